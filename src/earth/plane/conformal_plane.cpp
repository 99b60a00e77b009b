#include "earth/plane/conformal_plane.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/LambertConformalConic.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <cmath>
#include <variant>

#include "base/number.h"

namespace thiessen {
namespace {

using GeographicLib::Constants;
using GeographicLib::LambertConformalConic;
using GeographicLib::PolarStereographic;
using GeographicLib::TransverseMercator;

using AnyProjection = std::variant<TransverseMercator, LambertConformalConic, PolarStereographic>;

AnyProjection projection_of(const PlaneParameters& p) {
  const double radius = Constants::WGS84_a();
  const double flattening = Constants::WGS84_f();
  switch (p.kind) {
    case ProjectionKind::lambert_conformal:
      return LambertConformalConic(radius, flattening, p.latitude, p.scale);
    case ProjectionKind::polar_stereographic:
      return PolarStereographic(radius, flattening, p.scale);
    case ProjectionKind::transverse_mercator:
      break;
  }
  return TransverseMercator(radius, flattening, p.scale);
}

/// A point of the plane and the scale there.
struct Projected {
  Point at;
  double scale = 1;
};

}  // namespace

struct ConformalPlane::Projection {
  AnyProjection any;
  double longitude;
  bool is_north;

  Projected forward(Point degrees) const {
    Projected there;
    double convergence = 0;
    if (const auto* polar = std::get_if<PolarStereographic>(&any)) {
      polar->Forward(is_north, degrees.y, degrees.x - longitude, there.at.x, there.at.y,
                     convergence, there.scale);
    } else if (const auto* conic = std::get_if<LambertConformalConic>(&any)) {
      conic->Forward(longitude, degrees.y, degrees.x, there.at.x, there.at.y, convergence,
                     there.scale);
    } else {
      std::get<TransverseMercator>(any).Forward(longitude, degrees.y, degrees.x, there.at.x,
                                                there.at.y, convergence, there.scale);
    }
    return there;
  }

  Point reverse(Point metres) const {
    Point degrees;
    if (const auto* polar = std::get_if<PolarStereographic>(&any)) {
      polar->Reverse(is_north, metres.x, metres.y, degrees.y, degrees.x);
      degrees.x = std::remainder(degrees.x + longitude, 360);
    } else if (const auto* conic = std::get_if<LambertConformalConic>(&any)) {
      conic->Reverse(longitude, metres.x, metres.y, degrees.y, degrees.x);
    } else {
      std::get<TransverseMercator>(any).Reverse(longitude, metres.x, metres.y, degrees.y,
                                                degrees.x);
    }
    return degrees;
  }
};

ConformalPlane::ConformalPlane(const PlaneParameters& parameters)
    : parameters_(parameters),
      projection_(std::make_shared<const Projection>(
          Projection{projection_of(parameters), parameters.longitude, parameters.latitude > 0})) {}

Point ConformalPlane::forward(Point degrees) const {
  return projection_->forward(degrees).at;
}

Point ConformalPlane::reverse(Point metres) const {
  return projection_->reverse(metres);
}

double ConformalPlane::scale_at(Point degrees) const {
  return projection_->forward(degrees).scale;
}

std::string ConformalPlane::proj_text() const {
  const std::string longitude = " +lon_0=" + shortest_text(parameters_.longitude);
  const std::string latitude = shortest_text(parameters_.latitude);
  std::string text;
  switch (parameters_.kind) {
    case ProjectionKind::transverse_mercator:
      text = "+proj=tmerc +lat_0=0" + longitude;
      break;
    case ProjectionKind::lambert_conformal:
      text = parameters_.latitude == 0
                 ? "+proj=merc" + longitude
                 : "+proj=lcc +lat_1=" + latitude + " +lat_0=" + latitude + longitude;
      break;
    case ProjectionKind::polar_stereographic:
      text = "+proj=stere +lat_0=" + latitude + longitude;
      break;
  }
  return text + " +k_0=" + shortest_text(parameters_.scale) +
         " +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs";
}

}  // namespace thiessen
