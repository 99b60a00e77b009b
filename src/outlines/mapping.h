#pragma once

#include <optional>
#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// What coordinates count: degrees over the Earth, or a length in a plane.
struct CoordinateKind {
  bool geographic = false;  ///< longitude and latitude, and not easting and northing
  double unit = 1;          ///< how many degrees one is, or how many metres

  double degrees_per_unit() const { return geographic ? unit : 0; }
  double metres_per_unit() const { return geographic ? 0 : unit; }
  bool in_degrees() const { return geographic && unit == 1; }
};

/// What takes the points of outlines from one system of coordinates to another. Outlines know no
/// more of a projection than this, so that they are built and tested without the libraries that
/// have them. Not safe for two threads at once.
class Mapping {
 public:
  virtual ~Mapping() = default;

  virtual CoordinateKind from() const = 0;
  virtual CoordinateKind to() const = 0;
  /// Whether both are the same, so that points stay as they are, bit for bit.
  virtual bool identity() const = 0;
  /// Takes all of them, in place; the flag is false for each that lies outside the area in which
  /// the mapping is good, and its point is then not changed.
  virtual std::vector<bool> apply(std::vector<Point>& points) const = 0;
  /// The same without a proof, for points that are known to lie inside the area. A point that
  /// cannot be taken becomes NaN.
  virtual void apply_unproved(std::vector<Point>& points) const = 0;

  /// Nothing where the point lies outside the area.
  std::optional<Point> operator()(Point point) const {
    std::vector<Point> one = {point};
    if (!apply(one)[0]) return std::nullopt;
    return one[0];
  }
};

}  // namespace thiessen
