#include "cli/outputs/study_package_of.h"

#include <limits>
#include <utility>

#include "cli/outputs/rasters/isohyets_in.h"
#include "cli/outputs/rasters/raster_of.h"
#include "map/sheet/qgis_layer_style.h"
#include "results/weights_file.h"

namespace thiessen::cli {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<StudyLayers::Gauge> gauges_of(const Inputs& inputs, const GaugeReadings* readings) {
  std::vector<StudyLayers::Gauge> gauges;
  std::vector<Point> places;
  const auto add = [&](const Station& station, double rainfall) {
    gauges.push_back({station.id, {}, rainfall});
    places.push_back(station.position);
  };
  const std::vector<Station>& stations = inputs.network().stations();
  for (std::size_t i = 0; i < stations.size(); ++i)
    add(stations[i], readings == nullptr ? none : readings->readings[i]);
  for (const Station& station : inputs.never_reporting()) add(station, none);
  from_study(inputs)(places);
  for (std::size_t i = 0; i < gauges.size(); ++i) gauges[i].position = places[i];
  return gauges;
}

std::vector<BasinSummary> basins_of(const Inputs& inputs,
                                    const std::vector<BasinWeights>& weights) {
  std::vector<BasinSummary> basins;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    BasinSummary& basin = basins.emplace_back();
    basin.basin = inputs.basins()[b].id;
    basin.area = weights[b].area * inputs.area_unit().km2;
  }
  return basins;
}

std::vector<LayerStyle> styles_of(const PackageParts& parts) {
  const std::vector<StyledClass> classes =
      parts.classes ? styled_classes(*parts.classes, parts.unit) : std::vector<StyledClass>();
  std::vector<LayerStyle> styles{{"cells", style_of_cells(classes)},
                                 {"gauges", style_of_gauges(parts.readings != nullptr)},
                                 {"basins", style_of_basins()}};
  if (parts.interval > 0) styles.push_back({"isohyets", style_of_isohyets()});
  return styles;
}

}  // namespace

StudyPackage study_package_of(const Inputs& inputs, CellsOutput cells, const PackageParts& parts) {
  StudyPackage package;
  package.cells = std::move(cells);
  package.layers.gauges = gauges_of(inputs, parts.readings);
  package.layers.basin_shapes = areas_of(inputs);
  package.layers.basins = basins_of(inputs, *parts.weights);
  package.layers.has_factors = inputs.weighing().normals() != nullptr;
  package.layers.weights = weight_rows(inputs.weighing(), *parts.weights, inputs.area_unit());
  if (parts.interval > 0 && parts.readings != nullptr) {
    package.layers.isohyets =
        isohyets_in(inputs, *parts.readings, SurfaceMethod::natural, {}, {parts.interval, {}},
                    package.layers.basin_shapes, parts.threads);
  }
  package.layers.styles = styles_of(parts);
  return package;
}

}  // namespace thiessen::cli
