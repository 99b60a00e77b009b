#include "cli/cell_features.h"

#include <limits>

namespace thiessen::cli {

std::vector<std::vector<StationCell>> cells_of(const Session& session,
                                               const GaugeReadings* readings, unsigned threads) {
  return session.weighing().cells(readings == nullptr ? session.all_report() : readings->reports(),
                                  threads);
}

CellsOutput cells_output(const Session& session, const std::vector<std::vector<StationCell>>& cells,
                         const GaugeReadings* readings, const StudyOptions& options) {
  CellsOutput output;
  output.has_rainfall = readings != nullptr;
  output.attributes = options.attributes ? &session.study().attributes : nullptr;
  output.study_crs = session.study().crs;
  output.file_crs = session.study().output_crs();
  output.tolerance = options.tolerance();
  for (std::size_t b = 0; b < cells.size(); ++b) {
    for (const StationCell& cell : cells[b]) {
      CellFeature& feature = output.cells.emplace_back();
      feature.station = session.network().stations()[index(cell.station)].id;
      if (session.has_basins()) feature.basin = session.basins()[b].id;
      feature.area_km2 = cell.area * session.area_unit().km2;
      feature.weight = cell.weight;
      feature.rainfall = readings == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                             : readings->readings[index(cell.station)];
      feature.attribute_row = index(cell.station);
      feature.shape = cell.shape;
    }
  }
  return output;
}

void warn_of_own_coordinates(const Session& session, const std::string& file, Warnings& warnings) {
  if (session.study().crs) return;
  warnings.add({file == "-" ? "standard output" : file, 0,
                "the cells are in the plane's own coordinates: no CRS is known", ""});
}

}  // namespace thiessen::cli
