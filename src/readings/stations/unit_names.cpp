#include "readings/stations/unit_names.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/utf8.h"
#include "readings/readings_layout.h"
#include "readings/units/rain_unit.h"
#include "text/table_over.h"

namespace thiessen {
namespace {

class UnitNames : public TableOver {
 public:
  /// What the columns are called, and the unit of each; empty where its name has none.
  struct Columns {
    std::vector<std::string> names;
    std::vector<std::string> units;
  };

  UnitNames(std::unique_ptr<Table> table, Columns columns)
      : TableOver(std::move(table)), columns_(std::move(columns)) {}

  const std::vector<std::string>& header() const override { return columns_.names; }
  bool is_waiting(std::chrono::milliseconds patience) override {
    return table_->is_waiting(patience);
  }
  std::string unit(std::size_t field) const override {
    return columns_.units[field].empty() ? table_->unit(field) : columns_.units[field];
  }

 private:
  std::unique_ptr<Table> over(std::unique_ptr<Table> table) const override {
    return std::make_unique<UnitNames>(std::move(table), columns_);
  }

  Columns columns_;
};

/// An id with a unit behind it.
struct NameWithUnit {
  std::string id;
  std::string unit;
};

/// A unit of rain alone counts: a_m may be the metres of anything, or the mean of a.
std::optional<NameWithUnit> name_with_unit(std::string_view name,
                                           const ReadingsStations& stations) {
  name = trimmed(name);
  for (std::size_t end = name.size(); end-- > 1;) {
    const auto unit = unit_in_suffix(name.substr(end));
    if (!unit || unit->name() == "m" || unit->name() == "ft") continue;
    const std::string_view id = trimmed(name.substr(0, end));
    if (stations.find(id).standing == ReadingsStations::Standing::unknown) continue;
    return NameWithUnit{std::string(id), unit->name()};
  }
  return std::nullopt;
}

/// Requires columns of stations to say the same of their unit.
class UnitAgreement {
 public:
  explicit UnitAgreement(const Table& table) : table_(table) {}

  void see(std::size_t column, const std::string& unit) {
    const std::string below = table_.unit(column);
    if (!below.empty() && !unit.empty() && !is_same(below, unit))
      fail("column " + name(column) + " is in " + unit + " by its name, and in " + below +
           " by the row below it");
    if (!first_) {
      first_ = column;
      unit_ = unit;
    } else if (unit != unit_) {
      fail("column " + name(*first_) + in_words(unit_) + ", and column " + name(column) +
           in_words(unit));
    }
  }

 private:
  static bool is_same(const std::string& one, const std::string& other) {
    const auto unit = rain_unit(one);
    return unit && unit->name() == other;
  }
  static std::string in_words(const std::string& unit) {
    return unit.empty() ? " has no unit in its name" : " is in " + unit + " by its name";
  }
  std::string name(std::size_t column) const { return quoted(table_.header()[column], 60); }
  [[noreturn]] void fail(const std::string& text) const {
    throw Error({table_.file(), table_.header_line(), text,
                 setting("from_unit") + " says one unit for all"});
  }

  const Table& table_;
  std::optional<std::size_t> first_;
  std::string unit_;
};

}  // namespace

std::unique_ptr<Table> with_units_in_names(std::unique_ptr<Table> table,
                                           const ReadingsStations& stations,
                                           const ReadingsOptions& options) {
  if (!options.station_field.empty() || !options.value_field.empty()) return table;
  const auto& header = table->header();
  UnitNames::Columns columns{header, std::vector<std::string>(header.size())};
  const auto is_station = [&](std::size_t column) {
    return stations.find(header[column]).standing != ReadingsStations::Standing::unknown;
  };
  const std::unordered_set<std::string_view> names(header.begin(), header.end());
  bool has_units = false;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (is_station(i)) continue;
    const auto found = name_with_unit(header[i], stations);
    if (!found || names.contains(found->id)) continue;
    columns.names[i] = found->id;
    columns.units[i] = found->unit;
    has_units = true;
  }
  if (!has_units || find_layout(*table, stations, options).is_long) return table;
  if (!options.from_unit && !options.scale) {
    UnitAgreement agreement(*table);
    for (std::size_t i = 0; i < header.size(); ++i)
      if (is_station(i) || !columns.units[i].empty()) agreement.see(i, columns.units[i]);
  }
  return std::make_unique<UnitNames>(std::move(table), std::move(columns));
}

}  // namespace thiessen
