#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/colour.h"
#include "geometry/polygon.h"
#include "results/provenance.h"
#include "text/attributes.h"

namespace thiessen {

/// One cell to be written: the part of a basin that is a station's own.
struct CellFeature {
  std::string station;
  std::optional<std::string> basin;  ///< nothing where the run has no basins
  double area = 0;                   ///< in the unit that CellFeatures::area_column tells
  double weight = 0;
  double factor = 1;    ///< see StationWeight; written where CellFeatures::has_factor is set
  double rainfall = 0;  ///< mean over the cell in the basin; NaN: no value; written where
                        ///< CellFeatures::has_rainfall is set
  std::size_t attribute_row = 0;  ///< the station's row in CellFeatures::attributes
  MultiPolygon shape;             ///< in the study's coordinates; outer rings counter-clockwise
};

/// The cells of one output file. Neighbours share their edges vertex for vertex, with equal
/// doubles, so that no gap or overlap can open between them.
struct CellFeatures {
  std::vector<CellFeature> cells;
  bool has_rainfall = false;
  bool has_factor = false;
  std::vector<Colour> colours;  ///< by cell, for formats that say them; none where there are none
  std::string area_column = "area_km2";  ///< see AreaUnit::column
  std::string rainfall_is;  ///< what the values of rainfall are: a time, or which means
  /// The stations' attributes, where every field of a station is written with its cell; else null.
  const Attributes* attributes = nullptr;
  /// What the column of the shapes is called, where that must be no attribute's name.
  std::string geometry_column;
  std::optional<Provenance> made_by;  ///< what the file says of how it was made
};

/// The names under which the stations' attributes are written beside the cells' own fields
/// (station, basin, the area's, weight, rainfall, the shapes'): a name that is taken, case ignored,
/// gets underscores.
std::vector<FieldName> attribute_fields(const CellFeatures& features);

}  // namespace thiessen
