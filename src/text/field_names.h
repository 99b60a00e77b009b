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

/// Whether two names of a field are one: blanks round them, case, and whether words are parted by a
/// blank, `_`, `-` or `.` do not count (Station ID and station_id). Of letters beyond ASCII those
/// of Latin with an accent are compared without regard to case.
bool same_name(std::string_view a, std::string_view b);

/// The form of a name in which names that are one (see same_name) are the same text.
std::string plain_name(std::string_view name);

/// The index in `header` of the first of `names` that stands there (see same_name), or nothing
/// where none does.
std::optional<std::size_t> find_field(const std::vector<std::string>& header,
                                      std::span<const std::string_view> names);

/// The index of the field that a setting names: the field with exactly this name, or else one that
/// differs only in case. Throws Error, listing the header's names, where there is none.
std::size_t require_field(const std::vector<std::string>& header, const std::string& name,
                          const Wording& its_setting, const std::string& file, std::size_t line);

/// Known names for a message, all of them and bare: `lon, long, longitude`.
std::string listed(std::span<const std::string_view> names);
/// A list of names for a message: `'a', 'b', 'c' and 7 more`.
std::string listed(const std::vector<std::string>& names);

/// Guesses the type that fits all texts seen. Numbers count as such only where they read back as
/// written, so that 007 and +5 stay text.
class FieldTypeGuess {
 public:
  void see(std::string_view text);
  FieldType type() const { return seen_ ? type_ : FieldType::text; }

 private:
  FieldType type_ = FieldType::integer;
  bool seen_ = false;
};

}  // namespace thiessen
