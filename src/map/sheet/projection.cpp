#include "map/sheet/projection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thiessen {
namespace {

constexpr double radian = std::numbers::pi / 180;
constexpr double equatorial_radius = 6378137;  // WGS 84, metres
constexpr double flattening = 1 / 298.257223563;

double eccentricity() {
  return std::sqrt(flattening * (2 - flattening));
}

double conformal_latitude(double phi) {
  const double e = eccentricity();
  return std::atan(std::sinh(std::asinh(std::tan(phi)) - e * std::atanh(e * std::sin(phi))));
}

/// The latitude of a conformal latitude: each step brings it nearer by the eccentricity's square.
double latitude_of(double chi) {
  constexpr int steps = 8;
  const double e = eccentricity();
  const double isometric = std::asinh(std::tan(chi));
  double phi = chi;
  for (int i = 0; i < steps; ++i)
    phi = std::atan(std::sinh(isometric + e * std::atanh(e * std::sin(phi))));
  return phi;
}

/// The radius of the sphere on which the conformal latitude keeps the scale at this latitude.
double conformal_radius(double phi) {
  const double nearly_pole = 89.9 * radian;
  phi = std::clamp(phi, -nearly_pole, nearly_pole);
  const double sine = eccentricity() * std::sin(phi);
  return equatorial_radius * std::cos(phi) /
         (std::sqrt(1 - sine * sine) * std::cos(conformal_latitude(phi)));
}

std::string degrees(double value, const char* positive, const char* negative) {
  const long long tenths = std::llround(std::abs(value) * 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + "° " +
         (value < 0 ? negative : positive);
}

}  // namespace

MapProjection MapProjection::plane(Point origin, double metres_per_unit) {
  MapProjection p;
  p.centre_ = origin;
  p.metres_per_unit_ = metres_per_unit;
  return p;
}

MapProjection MapProjection::stereographic(Point centre) {
  MapProjection p;
  p.kind_ = Kind::stereographic;
  p.centre_ = centre;
  p.chi_ = conformal_latitude(centre.y * radian);
  p.metres_per_unit_ = conformal_radius(centre.y * radian);
  return p;
}

MapProjection MapProjection::plate_carree(const LongitudeWindow& window, double latitude) {
  MapProjection p;
  p.kind_ = Kind::plate_carree;
  p.centre_ = {window.middle(), latitude};
  p.squeeze_ = std::cos(latitude * radian);
  p.metres_per_unit_ = equatorial_radius;
  return p;
}

Point MapProjection::operator()(Point study) const {
  if (kind_ == Kind::plane) return {study.x - centre_.x, study.y - centre_.y};
  const double lambda = (study.x - centre_.x) * radian;
  if (kind_ == Kind::plate_carree) return {lambda * squeeze_, study.y * radian};
  const double chi = conformal_latitude(study.y * radian);
  const double half = std::sin(lambda / 2);
  const double bend = 2 * std::cos(chi) * half * half;
  const double cosine = std::cos(chi - chi_) - std::cos(chi_) * bend;
  const double scale = 2 / std::max(1 + cosine, 0.01);
  return {scale * std::cos(chi) * std::sin(lambda),
          scale * (std::sin(chi - chi_) + std::sin(chi_) * bend)};
}

Point MapProjection::inverse(Point map) const {
  if (kind_ == Kind::plane) return {map.x + centre_.x, map.y + centre_.y};
  if (kind_ == Kind::plate_carree) return {centre_.x + map.x / squeeze_ / radian, map.y / radian};
  const double distance = std::hypot(map.x, map.y);
  if (distance == 0) return centre_;
  const double c = 2 * std::atan(distance / 2);
  const double sine =
      std::cos(c) * std::sin(chi_) + map.y / distance * std::sin(c) * std::cos(chi_);
  const double lambda = std::atan2(map.x * std::sin(c), distance * std::cos(chi_) * std::cos(c) -
                                                            map.y * std::sin(chi_) * std::sin(c));
  return {centre_.x + lambda / radian,
          latitude_of(std::asin(std::clamp(sine, -1.0, 1.0))) / radian};
}

double MapProjection::period() const {
  return kind_ == Kind::plate_carree ? 2 * std::numbers::pi * squeeze_ : 0;
}

std::string MapProjection::name() const {
  if (kind_ == Kind::plane) return {};
  if (kind_ == Kind::plate_carree) {
    return "plate carrée, true along " + degrees(centre_.y, "N", "S");
  }
  return "stereographic projection about " + degrees(centre_.y, "N", "S") + ", " +
         degrees(std::remainder(centre_.x, 360.0), "E", "W");
}

double angular_distance(Point a, Point b) {
  const double dy = std::sin((b.y - a.y) * radian / 2);
  const double dx = std::sin((b.x - a.x) * radian / 2);
  const double square = dy * dy + std::cos(a.y * radian) * std::cos(b.y * radian) * dx * dx;
  return 2 * std::asin(std::sqrt(std::clamp(square, 0.0, 1.0))) / radian;
}

}  // namespace thiessen
