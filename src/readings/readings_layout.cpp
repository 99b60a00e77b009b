#include "readings/readings_layout.h"

#include <algorithm>
#include <optional>
#include <span>

#include "base/utf8.h"
#include "readings/rain_unit.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::size_t names_told = 7;

bool means(std::string_view header, std::string_view name, bool with_unit) {
  header = trimmed(header);
  if (same_name(header, name)) return true;
  return with_unit && header.size() > name.size() &&
         same_name(header.substr(0, name.size()), name) &&
         unit_in_suffix(header.substr(name.size())).has_value();
}

std::string list(const std::vector<std::string>& header) {
  constexpr std::size_t shown = 10;
  std::string all;
  for (std::size_t i = 0; i < std::min(shown, header.size()); ++i) {
    all += (i > 0 ? ", " : "") + quoted(header[i], 60);
  }
  if (header.size() > shown) all += " and " + std::to_string(header.size() - shown) + " more";
  return all;
}

class LayoutFinder {
 public:
  LayoutFinder(const Table& table, const ReadingsStations& stations)
      : table_(table), stations_(stations) {}

  /// Finds the column that the user names. A column of exactly this name comes before one that
  /// differs in case.
  std::size_t column_named(const std::string& name, const Wording& its_setting) const {
    const auto& header = table_.header();
    auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) {
      found = std::find_if(header.begin(), header.end(), [&](const std::string& other) {
        return equal_ignoring_case(trimmed(other), trimmed(name));
      });
    }
    if (found == header.end()) fail("there is no column " + quoted(name), "see " + its_setting);
    return static_cast<std::size_t>(found - header.begin());
  }

  std::optional<std::size_t> column_among(Names names, bool with_unit) const {
    const auto& header = table_.header();
    for (const std::string_view name : names) {
      for (std::size_t i = 0; i < header.size(); ++i) {
        if (means(header[i], name, with_unit)) return i;
      }
    }
    return std::nullopt;
  }

  std::size_t column(const std::string& given, const Wording& its_setting, Names names,
                     bool with_unit) const {
    if (!given.empty()) return column_named(given, its_setting);
    const std::optional<std::size_t> found = column_among(names, with_unit);
    if (!found)
      fail("no column is called " + listed(names.first(std::min(names_told, names.size()))) +
               " or the like",
           its_setting + " names it");
    return *found;
  }

  bool is_station(std::size_t column) const {
    return stations_.find(table_.header()[column]).standing != ReadingsStations::Standing::unknown;
  }

  [[noreturn]] void fail(const std::string& text, const Wording& hint) const {
    throw Error({table_.file(), table_.header_line(),
                 text + "; the columns are " + list(table_.header()), hint});
  }

 private:
  const Table& table_;
  const ReadingsStations& stations_;
};

bool looks_long(const LayoutFinder& finder) {
  const auto station = finder.column_among(known::station_ids, false);
  const auto value = finder.column_among(known::values, true);
  return station && value && !finder.is_station(*station) && !finder.is_station(*value);
}

}  // namespace

ReadingsLayout find_layout(const Table& table, const ReadingsStations& stations,
                           const ReadingsOptions& options) {
  const LayoutFinder finder(table, stations);
  ReadingsLayout layout;
  layout.is_long =
      !options.station_field.empty() || !options.value_field.empty() || looks_long(finder);
  if (!layout.is_long) {
    if (!options.time_field.empty()) {
      layout.time = finder.column_named(options.time_field, setting("time_field"));
    }
    return layout;
  }
  layout.time = finder.column(options.time_field, setting("time_field"), known::times, false);
  layout.station =
      finder.column(options.station_field, setting("station_field"), known::station_ids, false);
  layout.value = finder.column(options.value_field, setting("value_field"), known::values, true);
  if (layout.time == layout.station || layout.time == layout.value ||
      layout.station == layout.value) {
    finder.fail("time, station and value are not three columns",
                "see " + setting("time_field") + ", " + setting("station_field") + " and " +
                    setting("value_field"));
  }
  return layout;
}

}  // namespace thiessen
