#include "cli/summary/summary_columns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>

#include "base/error.h"
#include "base/number.h"

namespace thiessen::cli {
namespace {

constexpr int most_decimals = 6;

/// The decimals that show so many digits of a value above 0.
int decimals_of(double value, int digits) {
  const double decimals = digits - 1 - std::floor(std::log10(value));
  return static_cast<int>(std::clamp(decimals, 0.0, static_cast<double>(most_decimals)));
}

/// The decimals of a column: so many digits of the middle one of the values above 0, and one of the
/// smallest; 0 where none is.
int common_decimals(std::vector<double> values, int digits) {
  std::erase_if(values, [](double value) { return !(value > 0); });
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return std::max(decimals_of(values[values.size() / 2], digits), decimals_of(values.front(), 1));
}

using Value = std::function<std::optional<double>(const BasinSummary&)>;

std::vector<double> values_of(std::span<const BasinSummary> basins, const Value& value) {
  std::vector<double> values;
  for (const BasinSummary& basin : basins) {
    if (const auto given = value(basin)) values.push_back(*given);
  }
  return values;
}

TableColumn column(const std::string& heading, std::span<const BasinSummary> basins,
                   const Value& value, int decimals) {
  TableColumn column{heading, {}};
  for (const BasinSummary& basin : basins) {
    const auto given = value(basin);
    column.values.push_back(given ? fixed_text(*given, decimals) : "-");
  }
  return column;
}

TableColumn texts(const std::string& heading, std::span<const BasinSummary> basins,
                  const std::function<std::string(const BasinSummary&)>& text, bool is_name) {
  TableColumn column{heading, {}, is_name};
  for (const BasinSummary& basin : basins) column.values.push_back(text(basin));
  return column;
}

}  // namespace

std::vector<TableColumn> summary_columns(std::span<const BasinSummary> basins,
                                         const std::string& area, const std::string& unit,
                                         const std::string& depth_unit) {
  const Value area_of = [](const BasinSummary& basin) { return basin.area; };
  const Value mean = [](const BasinSummary& basin) { return basin.mean; };
  const Value error = [](const BasinSummary& basin) { return basin.standard_error; };
  const Value largest = [](const BasinSummary& basin) { return basin.largest; };
  const Value influence = [](const BasinSummary& basin) {
    return basin.most_influential.empty() ? std::nullopt : std::optional(basin.influence);
  };
  const std::vector<double> errors = values_of(basins, error);
  const int decimals =
      errors.empty() ? common_decimals(values_of(basins, mean), 3) : common_decimals(errors, 2);
  std::vector<TableColumn> columns = {
      texts(
          "basin", basins, [](const BasinSummary& basin) { return printable(basin.basin); }, true),
      column(area, basins, area_of, common_decimals(values_of(basins, area_of), 4)),
      texts(
          "gauges inside / used", basins,
          [](const BasinSummary& basin) {
            return std::to_string(basin.gauges_inside) + " / " +
                   std::to_string(basin.gauges_weighing);
          },
          false),
      column(
          "largest weight", basins, [](const BasinSummary& basin) { return basin.largest_weight; },
          3),
      column("mean" + unit, basins, mean, decimals),
      column("std. error" + unit, basins, error, decimals),
      column("largest" + unit, basins, largest, decimals),
  };
  for (std::size_t i = 0; !basins.empty() && i < basins.front().depths.size(); ++i) {
    const Value depth = [i](const BasinSummary& basin) { return basin.depths[i].depth; };
    columns.push_back(column("max " + basins.front().depths[i].length + depth_unit, basins, depth,
                             common_decimals(values_of(basins, depth), 3)));
  }
  std::vector<TableColumn> rest = {
      texts(
          "empty steps", basins,
          [](const BasinSummary& basin) { return std::to_string(basin.empty_steps); }, false),
      texts(
          "most influential gauge", basins,
          [](const BasinSummary& basin) {
            return basin.most_influential.empty() ? "-" : printable(basin.most_influential);
          },
          true),
      column("moves it" + unit, basins, influence,
             common_decimals(values_of(basins, influence), 2)),
  };
  std::move(rest.begin(), rest.end(), std::back_inserter(columns));
  return columns;
}

}  // namespace thiessen::cli
