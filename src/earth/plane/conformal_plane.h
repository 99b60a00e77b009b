#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "geometry/point.h"

namespace thiessen {

/// The conformal projections that a plane may be made with.
enum class ProjectionKind : std::uint8_t {
  transverse_mercator,
  lambert_conformal,  ///< a standard parallel at the equator makes it Mercator's
  polar_stereographic
};

/// What fixes a conformal projection of WGS 84.
struct PlaneParameters {
  ProjectionKind kind = ProjectionKind::transverse_mercator;
  double longitude = 0;  ///< of the meridian that runs north in the plane, in degrees
  /// Degrees. Lambert: the standard parallel, 0 or between 0.5 and 89 from the equator; northings
  /// count from it. Stereographic: the pole, -90 or 90. Transverse Mercator: 0, the equator.
  double latitude = 0;
  /// The scale along the central meridian, along the standard parallel, or at the pole.
  double scale = 1;
};

/// A plane of metres made of the WGS 84 ellipsoid by a conformal projection of GeographicLib's:
/// transverse Mercator (Krueger's series to the sixth order), Lambert conformal conic with one
/// standard parallel, or polar stereographic.
///
/// Laws: 1. `forward` gives the coordinates that PROJ gives by `proj_text`, to a micrometre.
/// 2. reverse(forward(p)) is p to 1e-8 metres. Both hold where the scale is at most 1.5 times that
/// of the projection's centre, to which a StudyPlane keeps; the tests measure them there.
///
/// Cost: 1 microsecond a point each way. Sources: C. F. F. Karney, Transverse Mercator with an
/// accuracy of a few nanometers, 2011; J. P. Snyder, Map projections: a working manual, 1987.
class ConformalPlane {
 public:
  explicit ConformalPlane(const PlaneParameters& parameters);

  const PlaneParameters& parameters() const { return parameters_; }
  /// Takes longitude and latitude in degrees to easting and northing in metres. What the projection
  /// sends to infinity is not finite.
  Point forward(Point degrees) const;
  /// Takes easting and northing to longitude, in [-180, 180], and latitude.
  Point reverse(Point metres) const;
  /// How long a metre of the Earth is in the plane, at a longitude and latitude.
  double scale_at(Point degrees) const;
  /// The definition of the plane as PROJ, and whatever reads PROJ's texts, has it.
  std::string proj_text() const;

 private:
  struct Projection;
  PlaneParameters parameters_;
  std::shared_ptr<const Projection> projection_;
};

}  // namespace thiessen
