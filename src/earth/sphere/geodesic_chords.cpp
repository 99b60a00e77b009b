#include "earth/sphere/geodesic_chords.h"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/interrupt.h"
#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

using GeographicLib::Geodesic;
using GeographicLib::GeodesicLine;

constexpr double longest_chord = 5e5;  // metres

bool is_pole(Point p) {
  return std::abs(p.y) == 90;
}

/// A geodesic whose points are told by their distance from its beginning.
class Course {
 public:
  Course(Point from, Point to, double tolerance)
      : line_(Geodesic::WGS84().InverseLine(
            from.y, from.x, to.y, to.x,
            Geodesic::LATITUDE | Geodesic::LONGITUDE | Geodesic::DISTANCE_IN)),
        from_(from),
        tolerance_(tolerance) {}

  std::vector<Point> bends() && {
    const double length = line_.Distance();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / longest_chord)));
    Place before{0, from_};
    for (int i = 1; i <= pieces; ++i) {
      const Place next = at(length * i / pieces);
      add_bends(before, next);
      if (i < pieces) bends_.push_back(next.position);
      before = next;
    }
    for (Point& bend : bends_) bend.x = std::remainder(bend.x, 360);
    return std::move(bends_);
  }

 private:
  /// A point of the geodesic; its longitude runs on over the antimeridian.
  struct Place {
    double distance;
    Point position;
  };

  Place at(double distance) const {
    double latitude = 0, longitude = 0, unused = 0;
    line_.GenPosition(false, distance,
                      Geodesic::LATITUDE | Geodesic::LONGITUDE | Geodesic::LONG_UNROLL, latitude,
                      longitude, unused, unused, unused, unused, unused, unused);
    return {distance, {longitude, latitude}};
  }

  void add_bends(const Place& from, const Place& to) {
    if (to.distance - from.distance <= tolerance_ || is_fine(from, to)) return;
    throw_if_interrupted();
    const Place middle = at(from.distance + (to.distance - from.distance) / 2);
    add_bends(from, middle);
    bends_.push_back(middle.position);
    add_bends(middle, to);
  }

  // Looks at the quarters too, because a geodesic over the equator bends both ways.
  bool is_fine(const Place& from, const Place& to) const {
    return std::all_of(shares.begin(), shares.end(), [&](double share) {
      const Point on_chord{from.position.x + share * (to.position.x - from.position.x),
                           from.position.y + share * (to.position.y - from.position.y)};
      const Place there = at(from.distance + share * (to.distance - from.distance));
      return geodesic_distance(there.position, on_chord) <= tolerance_;
    });
  }
  static constexpr std::array<double, 3> shares = {0.5, 0.25, 0.75};

  GeodesicLine line_;
  Point from_;
  double tolerance_;
  std::vector<Point> bends_;
};

}  // namespace

std::vector<Point> geodesic_chords(Point a, Point b, double tolerance) {
  if (b < a) {
    std::vector<Point> bends = geodesic_chords(b, a, tolerance);
    std::reverse(bends.begin(), bends.end());
    return bends;
  }
  if (is_pole(a) || is_pole(b) || a.x == b.x) return {};
  // The shortest path to the meridian half a turn away leads over the nearer pole.
  if (std::abs(std::remainder(b.x - a.x, 360)) == 180) {
    const double pole = a.y + b.y >= 0 ? 90 : -90;
    return {{a.x, pole}, {b.x, pole}};
  }
  return Course(a, b, tolerance).bends();
}

}  // namespace thiessen
