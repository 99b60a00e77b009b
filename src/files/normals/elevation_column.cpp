#include "files/normals/elevation_column.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

/// Codes for missing elevations; -999.9 is that of GHCN's list of stations.
constexpr std::array codes = {-999.0, -999.9, -9999.0, -9999.9, -99999.0, -32768.0};

std::size_t required(const Features& features, const std::string& name, const Wording& else_hint) {
  try {
    return require_field(features.header(), name, setting("elevation_field"), features.file(),
                         features.header_line());
  } catch (const Error& error) {
    Message message = error.messages().front();
    message.hint = else_hint;
    throw Error(std::move(message));
  }
}

}  // namespace

bool is_missing_elevation(double elevation) {
  return !std::isfinite(elevation) ||
         std::find(codes.begin(), codes.end(), elevation) != codes.end();
}

ElevationColumn::ElevationColumn(const Features& features, const std::optional<std::string>& wanted,
                                 const Wording& else_hint) {
  if (!wanted) return;
  column_ = wanted->empty() ? find_field(features.header(), known::elevations)
                            : required(features, *wanted, else_hint);
  if (column_) name_ = features.header()[*column_];
}

double ElevationColumn::read(const Features& features, const std::string& what,
                             Complaints& complaints) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const std::string_view text = trimmed(features.row().fields[*column_]);
  const auto number = parse_number(text, features.decimal_mark());
  if (number) return is_missing_elevation(number.value) ? none : number.value;
  if (text.empty() || text == "NA" || text == "NaN" || text == "nan") return none;
  complaints.add(features.message(what + " has an elevation in " + quoted(name_, 80) +
                                  " that is no number: " + quoted(text, 60)));
  return none;
}

}  // namespace thiessen
