#pragma once

#include "earth/plane/conformal_plane.h"
#include "gdal/crs/transformation.h"
#include "outlines/mapping.h"

namespace thiessen {

/// Maps coordinates of a file to a plane that was made for the study: by PROJ from the file's CRS
/// to WGS 84, and from there by GeographicLib. A point lies outside the area where either is not
/// good, which for the plane is where its inverse misses the point by more than 0.1 m.
class PlaneMapping : public Mapping {
 public:
  /// `degrees` is WGS 84 over the study's area. Throws Error where no transformation of datum is
  /// known.
  PlaneMapping(const Crs& from, const Crs& degrees, const ConformalPlane& plane);

  CoordinateKind from() const override { return to_degrees_.from(); }
  CoordinateKind to() const override { return {false, 1}; }
  bool identity() const override { return false; }
  std::vector<bool> apply(std::vector<Point>& points) const override;
  void apply_unproved(std::vector<Point>& points) const override;

 private:
  Transformation to_degrees_;
  ConformalPlane plane_;
};

}  // namespace thiessen
