#include "files/study_package.h"

#include <string>
#include <utility>
#include <vector>

#include "gdal/output/kept_layers.h"

namespace thiessen {
namespace {

std::vector<std::string> all_layers() {
  return {"cells", "gauges", "basins", "isohyets", "weights", "rain"};
}

std::vector<std::string> layers_of(const StudyLayers& layers) {
  std::vector<std::string> names = all_layers();
  if (!layers.isohyets) std::erase(names, "isohyets");
  if (!layers.rain) std::erase(names, "rain");
  return names;
}

}  // namespace

std::string study_package(StudyPackage package, const std::string& path, const std::string& older,
                          Warnings& warnings) {
  const CellsOutput& cells = package.cells;
  StudyLayers& layers = package.layers;
  layers.crs = cells.file_crs ? cells.file_crs : cells.study_crs;
  layers.made_by = cells.made_by;
  layers.area_column = cells.area_column;
  layers.has_rainfall = cells.has_rainfall;
  const std::string kept = kept_layers(older, all_layers(), layers_of(layers), path, warnings);
  std::string bytes = std::move(cells_files(cells, path, warnings, kept).front().bytes);
  return with_study_layers(std::move(bytes), layers, path, warnings);
}

}  // namespace thiessen
