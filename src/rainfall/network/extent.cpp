#include "rainfall/network/extent.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/box.h"

namespace thiessen {
namespace {

constexpr double widest_gap_of_a_cap = 180;

bool at_pole(Point p) {
  return std::abs(p.y) == 90;
}

/// The way that leaves out the widest gap between longitudes: it begins east of the gap and goes
/// eastward to the place west of it.
struct WayRound {
  double west = -180;
  double east = 180;
  double gap = 0;  ///< degrees; 360 where all places stand on one meridian
};

WayRound shorter_way_round(std::span<const Point> places) {
  std::vector<double> longitudes;
  for (const Point p : places) {
    if (!at_pole(p)) longitudes.push_back(p.x);
  }
  if (longitudes.empty()) return {};
  std::sort(longitudes.begin(), longitudes.end());
  WayRound way{longitudes.front(), longitudes.back(), longitudes.front() + 360 - longitudes.back()};
  for (std::size_t i = 1; i < longitudes.size(); ++i) {
    const double gap = longitudes[i] - longitudes[i - 1];
    if (gap > way.gap) way = {longitudes[i], longitudes[i - 1] + 360, gap};
  }
  return way;
}

Box on_earth(Box box) {
  if (box.width() >= 360) {
    box.low.x = -180;
    box.high.x = 180;
  }
  box.low.y = std::max(box.low.y, -90.0);
  box.high.y = std::min(box.high.y, 90.0);
  return box;
}

/// The extent of places all round the Earth, between the latitudes of `box`.
Box all_round(const Box& box, double margin) {
  const double grown = 1 + margin / 100;
  Box extent{{-180, box.low.y}, {180, box.high.y}};
  if (box.low.y >= 0 && box.high.y > 0) {
    extent = {{-180, 90 - grown * (90 - box.low.y)}, {180, 90}};
  } else if (box.high.y <= 0 && box.low.y < 0) {
    extent = {{-180, -90}, {180, -90 + grown * (90 + box.high.y)}};
  } else {
    extent = extent.grown(extent.width() * margin / 100);
  }
  return on_earth(extent);
}

/// The extent of several places on the Earth.
Box extent_on_earth(std::span<const Point> places, Box box, double margin) {
  const WayRound way = shorter_way_round(places);
  if (way.gap < widest_gap_of_a_cap) return all_round(box, margin);
  box.low.x = way.west;
  box.high.x = way.east;
  return on_earth(box.grown(std::max(box.width(), box.height()) * margin / 100));
}

/// The box's outline, in edges of at most `longest`. On the Earth an edge of more than half a turn
/// would be taken to go the other way round, so none is longer than a quarter.
Ring outline(const Box& box, double longest) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(box.width() / longest)));
  const auto x = [&](int i) {
    return i == pieces ? box.high.x : box.low.x + box.width() * i / pieces;
  };
  Ring ring;
  for (int i = 0; i <= pieces; ++i) ring.push_back({x(i), box.low.y});
  for (int i = pieces; i >= 0; --i) ring.push_back({x(i), box.high.y});
  return ring;
}

}  // namespace

std::optional<Basin> extent_of(std::span<const Point> places, Metric metric, double margin) {
  Box box;
  for (const Point p : places) box.take_in(p);
  if (metric == Metric::planar) {
    box = box.grown(std::max(box.width(), box.height()) * margin / 100);
  } else if (std::all_of(places.begin(), places.end(), [&](Point p) { return p == places[0]; })) {
    box = {{-180, -90}, {180, 90}};
  } else {
    box = extent_on_earth(places, box, margin);
  }
  if (!(box.width() > 0 && box.height() > 0)) return {};
  const double longest = metric == Metric::geodesic ? 90 : box.width();
  return Basin{"", {{outline(box, longest), {}}}, {}};
}

}  // namespace thiessen
