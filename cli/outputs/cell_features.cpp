#include "cli/outputs/cell_features.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

#include "cli/outputs/provenance_of.h"

namespace thiessen::cli {
namespace {

void fill(CellFeature& feature, const Inputs& inputs, const GaugeReadings* readings,
          std::size_t basin, StationCell&& cell) {
  feature.station = inputs.network().stations()[index(cell.station)].id;
  if (inputs.has_basins()) feature.basin = inputs.basins()[basin].id;
  feature.area = cell.area * inputs.area_unit().km2;
  feature.weight = cell.weight;
  feature.factor = cell.factor;
  feature.rainfall = readings == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                         : cell.factor * readings->readings[index(cell.station)];
  feature.attribute_row = index(cell.station);
  feature.shape = std::move(cell.shape);
}

}  // namespace

std::vector<std::vector<StationCell>> cells_of(const Inputs& inputs, const GaugeReadings* readings,
                                               unsigned threads) {
  if (readings == nullptr) return cells_of_network(inputs, threads);
  return inputs.weighing().cells(readings->reports(), threads, readings->month);
}

std::vector<std::vector<StationCell>> cells_of_network(const Inputs& inputs, unsigned threads) {
  return inputs.weighing().cells(inputs.all_report(), threads);
}

CellsOutput cells_output(const Inputs& inputs, std::vector<std::vector<StationCell>> cells,
                         const GaugeReadings* readings, const StudyOptions& options,
                         const std::string& unit) {
  CellsOutput output;
  output.has_rainfall = readings != nullptr;
  output.area_column = inputs.area_unit().column();
  if (readings != nullptr) output.rainfall_is = readings->label;
  output.attributes = options.attributes ? &inputs.study().attributes : nullptr;
  output.study_crs = inputs.study().crs;
  output.file_crs = inputs.study().output_crs();
  output.tolerance = options.tolerance();
  output.made_by = provenance_of(inputs, options, readings, unit);
  output.has_factor = inputs.weighing().normals() != nullptr;
  for (std::size_t b = 0; b < cells.size(); ++b) {
    for (StationCell& cell : cells[b])
      fill(output.cells.emplace_back(), inputs, readings, b, std::move(cell));
  }
  return output;
}

CellSource cell_source(const Inputs& inputs, const GaugeReadings* readings, unsigned threads) {
  return [&inputs, readings, threads](const std::function<bool(const CellFeature& cell)>& take) {
    CellFeature feature;
    inputs.weighing().for_each_cell(readings == nullptr ? inputs.all_report() : readings->reports(),
                                    threads, readings == nullptr ? NormalMonth() : readings->month,
                                    [&](std::size_t basin, StationCell&& cell) {
                                      fill(feature, inputs, readings, basin, std::move(cell));
                                      return take(feature);
                                    });
  };
}

void warn_of_own_coordinates(const Inputs& inputs, const std::string& file, Warnings& warnings) {
  if (inputs.study().crs) return;
  warnings.add({file == "-" ? "standard output" : file, 0,
                "the cells are in the plane's own coordinates: no CRS is known", ""});
}

}  // namespace thiessen::cli
