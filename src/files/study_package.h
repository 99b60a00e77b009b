#pragma once

#include <string>

#include "base/error.h"
#include "files/cells_file.h"
#include "gdal/output/study_layers.h"

namespace thiessen {

/// A whole study, to be written as one GeoPackage.
struct StudyPackage {
  CellsOutput cells;
  StudyLayers layers;  ///< of which the CRS, the column of areas and more are those of the cells
};

/// Encodes the study as a GeoPackage: a layer `cells`, what with_study_layers adds to it and, in
/// each layer's metadata, how it was made. `older` holds the bytes of a GeoPackage of which
/// kept_layers keeps what is no study's; it is empty where there is none. Throws Error as
/// cells_files does. Memory: twice the file. Cost: linear in its rows, and the R-trees.
std::string study_package(StudyPackage package, const std::string& path, const std::string& older,
                          Warnings& warnings);

}  // namespace thiessen
