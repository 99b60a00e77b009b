#include "files/normals/normal_columns.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "base/number.h"
#include "base/utf8.h"
#include "text/field_names.h"

namespace thiessen {

NormalColumns::NormalColumns(const Features& features, const std::string& name) {
  if (name.empty()) return;
  const std::vector<std::string>& header = features.header();
  constexpr int months = 12;
  for (int month = 1; month <= months; ++month) {
    const std::string of_month = name + (month < 10 ? "_0" : "_") + std::to_string(month);
    const std::string_view text = of_month;
    const auto column = find_field(header, {&text, 1});
    if (column) columns_.push_back(*column);
  }
  const std::string_view text = name;
  const bool has_one = find_field(header, {&text, 1}).has_value();
  if (!has_one && columns_.size() == months) return;
  if (!has_one && !columns_.empty()) {
    throw Error({features.file(), features.header_line(),
                 "has " + std::to_string(columns_.size()) + " of the twelve fields " +
                     quoted(name + "_01", 80) + " to " + quoted(name + "_12", 80),
                 "calendar months have normals all together, or one field has the year's"});
  }
  columns_ = {require_field(header, name, setting("normal_field"), features.file(),
                            features.header_line())};
}

std::vector<double> NormalColumns::read(const Features& features, const std::string& what,
                                        Complaints& complaints) const {
  std::vector<double> normals;
  for (const std::size_t column : columns_) {
    const std::string_view text = trimmed(features.row().fields[column]);
    const auto number = parse_number(text, features.decimal_mark());
    normals.push_back(number ? number.value : std::numeric_limits<double>::quiet_NaN());
    if (number || text.empty()) continue;
    complaints.add(features.message(what + " has a normal in " +
                                    quoted(features.header()[column], 80) +
                                    " that is no number: " + quoted(text, 60)));
  }
  return normals;
}

}  // namespace thiessen
