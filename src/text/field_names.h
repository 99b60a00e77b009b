#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/wording.h"
#include "text/attributes.h"

namespace thiessen {

/// Where in `header` the first of `names` stands that stands there at all, case ignored.
std::optional<std::size_t> find_field(const std::vector<std::string>& header,
                                      std::span<const std::string_view> names);

/// Where the field stands that a setting names: written alike, else alike but for case. Throws
/// Error, listing the header's names, where there is none.
std::size_t require_field(const std::vector<std::string>& header, const std::string& name,
                          const Wording& its_setting, const std::string& file, std::size_t line);

/// `'a', 'b', 'c' and 7 more`.
std::string listed(const std::vector<std::string>& names);

/// What all texts seen may stand for: numbers only where they read back as written, so that 007 and
/// +5 stay text.
class FieldTypeGuess {
 public:
  void see(std::string_view text);
  FieldType type() const { return seen_ ? type_ : FieldType::text; }

 private:
  FieldType type_ = FieldType::integer;
  bool seen_ = false;
};

}  // namespace thiessen
