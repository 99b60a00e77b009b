#pragma once

#include <span>
#include <string>
#include <vector>

#include "outlines/vertex_rounding.h"
#include "results/cell_features.h"

namespace thiessen {

/// Writes cells as cells_geojson does, one after the other.
class CellsGeojson {
 public:
  /// `features` tells what the cells have in common; cells of its own are not written. Both have to
  /// outlive this object.
  CellsGeojson(const CellFeatures& features, const VertexRounding& rounding);

  /// Appends what stands before the first cell.
  void begin(std::string& out) const;
  void append(std::string& out, const CellFeature& cell, const MultiPolygon& shape);
  /// Appends what stands after the last cell.
  void end(std::string& out) const;

 private:
  const CellFeatures& features_;
  const VertexRounding& rounding_;
  std::vector<FieldName> attributes_;
  bool any_ = false;
};

/// The cells as GeoJSON (RFC 7946), one feature a line, in their order. `shapes` holds the geometry
/// to write for each cell, outer rings counter-clockwise, in WGS 84 longitude and latitude cut at
/// the antimeridian or in the coordinates of a plane; a cell without a shape has a null geometry.
/// What the file says of how it was made stands before them, in a member `made_by` of software,
/// metric, plane, tolerance, method and unit. What the values of rainfall are stands in a member
/// `rainfall` of the collection. Cost: linear.
///
/// This writer is our own because GDAL's has one number of decimals for the whole file and writes
/// 0.1 as 0.10000000000000001.
std::string cells_geojson(const CellFeatures& features, std::span<const MultiPolygon> shapes,
                          const VertexRounding& rounding);

}  // namespace thiessen
