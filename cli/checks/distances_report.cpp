#include "cli/checks/distances_report.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/enumeration.h"
#include "base/number.h"
#include "base/utf8.h"
#include "basin/containment.h"
#include "cli/checks/text_table.h"
#include "study/gauge_spacing.h"
#include "study/ruler.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t longest_id = 40;
constexpr std::size_t named_at_most = 20;

std::string id_of(const Inputs& inputs, StationIndex station) {
  return quoted(inputs.network().stations()[index(station)].id, longest_id);
}

/// The gauges inside each basin, by basin, as positions in rising order.
std::vector<std::vector<std::size_t>> gauges_inside(const Inputs& inputs) {
  std::vector<Point> positions;
  for (const Station& station : inputs.network().stations()) positions.push_back(station.position);
  const double period = inputs.study().metric == Metric::geodesic ? 360 : 0;
  return points_within(inputs.basins(), positions, period);
}

}  // namespace

std::string odd_gauges_text(const Inputs& inputs) {
  std::string text;
  std::vector<std::string> names;
  for (const std::string& id : inputs.study().at_zero) names.push_back(quoted(id, longest_id));
  if (!names.empty())
    text += "gauges at 0, 0, as missing coordinates are often written: " +
            enumerated_up_to(named_at_most, names) + "\n";
  names.clear();
  const Ruler ruler(inputs.study());
  for (const LonelyPlace& place : lonely_places(spacing_of(inputs.network().places(), ruler))) {
    names.push_back(id_of(inputs, inputs.network().stations_at(place.place).front()) + " (" +
                    ruler.text(place.distance) + ")");
  }
  if (!names.empty())
    text += "gauges far from all others: " + enumerated_up_to(named_at_most, names) + "\n";
  return text;
}

std::string nearest_gauges_table(const Inputs& inputs) {
  const Ruler ruler(inputs.study());
  const auto inside = gauges_inside(inputs);
  const std::vector<NearestGauge>& nearest = inputs.whole().nearest_gauges();
  const auto distance = [&](std::size_t b) { return inside[b].empty() ? nearest[b].distance : 0; };
  std::vector<std::size_t> order(nearest.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distance(a) > distance(b); });
  std::vector<std::vector<std::string>> rows{
      {"basin", "gauges inside", "nearest gauge", "distance"}};
  for (const std::size_t b : order) {
    const StationIndex station = inside[b].empty()
                                     ? inputs.network().stations_at(nearest[b].place).front()
                                     : StationIndex{static_cast<std::uint32_t>(inside[b].front())};
    rows.push_back({quoted(inputs.basins()[b].id, longest_id), std::to_string(inside[b].size()),
                    id_of(inputs, station),
                    inside[b].empty() ? ruler.text(distance(b)) : "inside"});
  }
  return "the nearest gauge of each basin, the farthest first:\n" + aligned(rows);
}

}  // namespace thiessen::cli
