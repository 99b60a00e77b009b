#include "files/study_package.h"

#include <utility>

namespace thiessen {

std::string study_package(StudyPackage package, const std::string& path, const std::string& older,
                          Warnings& warnings) {
  const CellsOutput& cells = package.cells;
  StudyLayers& layers = package.layers;
  layers.crs = cells.file_crs ? cells.file_crs : cells.study_crs;
  layers.made_by = cells.made_by;
  layers.area_column = cells.area_column;
  layers.has_rainfall = cells.has_rainfall;
  std::string bytes = std::move(cells_files(cells, path, warnings, older).front().bytes);
  return with_study_layers(std::move(bytes), layers, path, warnings);
}

}  // namespace thiessen
