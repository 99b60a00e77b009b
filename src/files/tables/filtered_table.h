#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "gdal/layers/attribute_filter.h"
#include "text/attributes.h"
#include "text/table_over.h"

namespace thiessen {

/// The rows of a table that an OGR attribute filter keeps. They are judged one by one, so that
/// memory does not grow with the table.
///
/// A table of texts states no types. A field that holds numbers alone in the first 64 kB is one of
/// numbers, and any other is text. Where the filter asks a field of numbers and a later row holds
/// something else in it, that is an error, for a comparison would be wrong in silence.
class FilteredTable : public TableOver {
 public:
  /// What is to be kept, and what the filter is called in messages.
  struct Filter {
    std::string where;
    std::string its_setting;
  };

  /// `fields` are those of the table with their types. A warning is given where no row is kept;
  /// `warnings` must outlive this object, and is null where nothing is to be said. Throws Error as
  /// AttributeFilter does.
  FilteredTable(std::unique_ptr<Table> table, Filter filter, std::vector<FieldName> fields,
                Warnings* warnings);

  bool next(Row& row) override;

 private:
  std::unique_ptr<Table> over(std::unique_ptr<Table> table) const override;
  bool next_row(Row& row);
  bool has_types(const Row& row);
  void conclude();

  Filter filter_;
  std::vector<FieldName> fields_;
  AttributeFilter keeps_;
  std::vector<std::size_t> numbers_;  ///< the fields of numbers that the filter asks
  Warnings* warnings_;                ///< null: nothing is said
  Complaints complaints_;
  std::size_t read_ = 0;
  std::size_t kept_ = 0;
};

/// The rows of a table that the filter keeps. `types` are those of the fields where the table
/// states them, and empty where they are to be found out. Throws Error as FilteredTable does, and
/// where a table of texts can be read only once.
std::unique_ptr<Table> keep_rows(std::unique_ptr<Table> table, FilteredTable::Filter filter,
                                 std::vector<FieldType> types, Warnings& warnings);

}  // namespace thiessen
