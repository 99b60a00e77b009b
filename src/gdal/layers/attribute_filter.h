#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "text/attributes.h"
#include "text/table.h"

namespace thiessen {

/// An OGR attribute filter (`elev > 1500 AND name LIKE 'A%'`) on the fields of a table. An empty
/// text is NULL. Numbers compare as numbers where the field's type is one, otherwise as text. FID
/// is the row's line or the feature's number.
class AttributeFilter {
 public:
  /// Compiles the filter `where` for a table with these fields. Throws Error, naming `its_setting`,
  /// where the filter is not an OGR expression or names a field that is not among them.
  AttributeFilter(const std::string& where, const std::string& its_setting, const std::string& file,
                  const std::vector<FieldName>& fields);
  ~AttributeFilter();

  /// The fields that the filter asks, in the order of the table.
  const std::vector<std::size_t>& fields_asked() const;
  /// Whether the row is to be kept. Throws Error where a text is not of its field's type.
  bool keeps(const Row& row) const;

 private:
  struct Query;
  std::unique_ptr<Query> query_;
};

}  // namespace thiessen
