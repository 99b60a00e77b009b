#include "earth/geodesic.h"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/Math.hpp>
#include <cmath>

namespace thiessen {
namespace {

using GeographicLib::Geodesic;
using GeographicLib::Math;

}  // namespace

Arrival arrival(Point place, Point at) {
  Arrival there{};
  double leaving = 0;
  double arriving = 0;
  Geodesic::WGS84().Inverse(place.y, place.x, at.y, at.x, there.distance, leaving, arriving);
  Math::sincosd(arriving, there.east, there.north);
  return there;
}

double geodesic_distance(Point a, Point b) {
  double distance = 0;
  Geodesic::WGS84().Inverse(a.y, a.x, b.y, b.x, distance);
  return distance;
}

Point moved(Point start, double east, double north) {
  const double length = std::hypot(east, north);
  if (length == 0) return start;
  Point end;
  Geodesic::WGS84().Direct(start.y, start.x, Math::atan2d(east, north), length, end.y, end.x);
  return end;
}

}  // namespace thiessen
