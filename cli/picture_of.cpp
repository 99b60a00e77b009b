#include "cli/picture_of.h"

#include <cmath>
#include <limits>

#include "gdal/crs.h"
#include "gdal/transformation.h"

namespace thiessen::cli {
namespace {

// Within 5 degrees, at the study area's centre, where its CRS tells.
bool is_north_up(const Inputs& inputs) {
  const StudyFiles& study = inputs.study();
  if (!study.crs || study.crs->geographic()) return true;
  const Point centre = inputs.weighing().frame().centre();
  const auto there = Transformation(*study.crs, Crs::wgs84())(centre);
  if (!there) return true;
  const double step = there->y < 89 ? 0.01 : -0.01;
  const auto north = Transformation(Crs::wgs84(), *study.crs)({there->x, there->y + step});
  if (!north) return false;
  const double east_shift = (north->x - centre.x) / step;
  const double north_shift = (north->y - centre.y) / step;
  constexpr double tangent_of_five_degrees = 0.0875;
  return north_shift > 0 && std::abs(east_shift) < tangent_of_five_degrees * north_shift;
}

}  // namespace

Picture picture_of(const Inputs& inputs, const std::vector<std::vector<StationCell>>& cells,
                   const GaugeReadings* readings, const ViewOptions& view) {
  const StudyFiles& study = inputs.study();
  Picture picture;
  picture.geographic = study.metric == Metric::geodesic || (study.crs && study.crs->geographic());
  picture.metres_per_unit =
      study.metres_per_unit.value_or(std::numeric_limits<double>::quiet_NaN());
  picture.north_is_up = picture.geographic || is_north_up(inputs);
  picture.by_rainfall = readings != nullptr;
  picture.title = !view.title.empty()   ? view.title
                  : readings != nullptr ? "Rainfall by Thiessen cells"
                                        : "Thiessen cells";
  picture.subtitle = readings != nullptr ? readings->label : "";
  picture.units = view.units;
  picture.width = static_cast<int>(view.size.width);
  picture.height = static_cast<int>(view.size.height);
  const std::vector<Station>& stations = inputs.network().stations();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const bool reports = readings == nullptr || !std::isnan(readings->readings[i]);
    picture.gauges.push_back({stations[i].position, stations[i].id, reports});
  }
  for (std::size_t b = 0; b < cells.size(); ++b) {
    for (const StationCell& cell : cells[b]) {
      const double rainfall = readings == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                                  : readings->readings[index(cell.station)];
      picture.cells.push_back({cell.shape, index(cell.station), rainfall});
    }
    const std::string name = inputs.has_basins() ? inputs.basins()[b].id : "";
    picture.basins.push_back({name, inputs.basins()[b].shape});
  }
  return picture;
}

}  // namespace thiessen::cli
