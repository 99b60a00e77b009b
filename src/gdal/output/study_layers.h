#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "gdal/crs/crs.h"
#include "gdal/output/isohyet_lines.h"
#include "gdal/output/layer_styles.h"
#include "geometry/point.h"
#include "geometry/polygon.h"
#include "results/provenance.h"
#include "results/summary_file.h"
#include "results/weights_file.h"

namespace thiessen {

/// What a study in one GeoPackage has beside its cells. Shapes and places are in the file's CRS.
struct StudyLayers {
  struct Gauge {
    std::string station;
    Point position;
    double rainfall = 0;  ///< NaN where it has none
  };
  /// A series, of which each value is a row.
  struct Rain {
    std::vector<std::string> times;
    std::vector<double> values;  ///< by step, then by basin; NaN where there is none
  };

  std::optional<Crs> crs;
  std::optional<Provenance> made_by;
  std::string area_column;  ///< see AreaUnit::column
  bool has_rainfall = false;
  std::vector<Gauge> gauges;
  std::vector<MultiPolygon> basin_shapes;
  std::vector<BasinSummary> basins;
  bool has_series = false;  ///< whether the summaries tell of a series, and not of areas alone
  std::vector<WeightRow> weights;
  bool has_factors = false;  ///< whether the weights have factors, of the year
  std::optional<Rain> rain;
  std::optional<std::vector<Isohyet>> isohyets;
  std::vector<LayerStyle> styles;
};

/// Adds to a GeoPackage layers `gauges`, `basins` and, where they are given, `isohyets`; tables
/// `weights` and, where a series is given, `rain` (time, basin, rainfall); and the styles. Layers
/// that it has under these names are replaced. `path` is its name in messages. Returns its bytes.
/// Throws Error where GDAL fails. Memory: twice the file. Cost: linear in its rows, and R-trees.
std::string with_study_layers(std::string geopackage, const StudyLayers& layers,
                              const std::string& path, Warnings& warnings);

}  // namespace thiessen
