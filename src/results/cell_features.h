#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "text/attributes.h"

namespace thiessen {

/// One cell to be written: a station's part of a basin.
struct CellFeature {
  std::string station;
  std::optional<std::string> basin;  ///< nothing where the run has no basins
  double area_km2 = 0;               ///< (CRS units)^2 where the unit is unknown
  double weight = 0;
  double rainfall = 0;            ///< NaN: no value. Written where CellFeatures::has_rainfall
  std::size_t attribute_row = 0;  ///< which row of CellFeatures::attributes is the station's
  MultiPolygon shape;             ///< in the study's coordinates; outer rings counter-clockwise
};

/// The cells of one output. Neighbours share their edges vertex for vertex, with equal doubles.
struct CellFeatures {
  std::vector<CellFeature> cells;
  bool has_rainfall = false;
  const Attributes* attributes = nullptr;  ///< where every field of the station is carried along
};

/// The names of the stations' attributes beside the cells' own fields (station, basin, area_km2,
/// weight, rainfall): a name that is taken, case ignored, gets underscores.
std::vector<FieldName> attribute_fields(const CellFeatures& features);

}  // namespace thiessen
