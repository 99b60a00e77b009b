#pragma once

#include <optional>
#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// The kind of a system of coordinates: degrees over the Earth, or lengths in a plane.
struct CoordinateKind {
  bool geographic = false;  ///< longitude and latitude, rather than easting and northing
  double unit = 1;          ///< degrees in one unit, or metres in one unit

  double degrees_per_unit() const { return geographic ? unit : 0; }
  double metres_per_unit() const { return geographic ? 0 : unit; }
  bool in_degrees() const { return geographic && unit == 1; }
};

/// Maps points of outlines from one system of coordinates to another. Outlines know no more of a
/// projection than this, so they are built and tested without the libraries that implement
/// projections. Not safe for two threads at once.
class Mapping {
 public:
  virtual ~Mapping() = default;

  virtual CoordinateKind from() const = 0;
  virtual CoordinateKind to() const = 0;
  /// Whether both systems are the same, so that points stay as they are, bit for bit.
  virtual bool identity() const = 0;
  /// Maps all points in place. The flag of a point is false where it lies outside the area in which
  /// the mapping is good; such a point is not changed.
  virtual std::vector<bool> apply(std::vector<Point>& points) const = 0;
  /// Maps all points in place without proof, for points that are known to lie inside the area. A
  /// point that cannot be mapped becomes NaN.
  virtual void apply_unproved(std::vector<Point>& points) const = 0;

  /// Maps one point; empty where it lies outside the area.
  std::optional<Point> operator()(Point point) const {
    std::vector<Point> one = {point};
    if (!apply(one)[0]) return std::nullopt;
    return one[0];
  }
};

}  // namespace thiessen
