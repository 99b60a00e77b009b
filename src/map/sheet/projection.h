#pragma once

#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "map/sheet/longitude_window.h"

namespace thiessen {

/// Projects the study's coordinates to the map's plane, x to the right, y up.
///
/// The oblique stereographic projection goes through the ellipsoid's conformal latitude (Snyder,
/// Map Projections: A Working Manual, 1987, pages 157 to 161, there through a conformal sphere): it
/// is conformal, and true to scale and north up at its centre. Its scale grows as 2 / (1 + cos c)
/// with the distance c from the centre. Plate carrée is squeezed by the cosine of a middle
/// latitude.
class MapProjection {
 public:
  enum class Kind { plane, stereographic, plate_carree };

  /// A plane's coordinates as they are, less `origin`, so that no digits are lost far from 0.
  static MapProjection plane(Point origin, double metres_per_unit);
  /// The oblique stereographic projection about `centre`, longitude and latitude in degrees.
  static MapProjection stereographic(Point centre);
  /// Plate carrée that is true to scale east-west along `latitude`, in degrees. `window` runs
  /// across the map.
  static MapProjection plate_carree(const LongitudeWindow& window, double latitude);

  Point operator()(Point study) const;
  /// The study's coordinates of a place on the map. On a map that repeats, longitudes run on.
  Point inverse(Point map) const;
  Kind kind() const { return kind_; }
  Point centre() const { return centre_; }
  /// The length of a map unit in metres at the map's centre; NaN where the plane's unit is unknown.
  double metres_per_unit() const { return metres_per_unit_; }
  /// The width of a whole turn in map units; 0 where the map does not repeat.
  double period() const;
  /// The name of the projection, such as "stereographic projection about 39.0° N, 105.5° W"; empty
  /// for a plane.
  std::string name() const;

 private:
  Kind kind_ = Kind::plane;
  Point centre_;
  double metres_per_unit_ = 1;
  double squeeze_ = 1;  ///< plate carrée: the cosine of the true latitude
  double chi_ = 0;      ///< stereographic: conformal latitude of the centre, in radians
};

/// The distance on a sphere between two positions; positions and distance are in degrees.
double angular_distance(Point a, Point b);

}  // namespace thiessen
