#include "rainfall/network/extent.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/box.h"

namespace thiessen {
namespace {

// The box that leaves out the widest gap in longitude: it begins at the place east of the gap and
// goes eastward to the place west of it.
Box shorter_way_round(std::span<const Point> places) {
  std::vector<double> longitudes;
  Box box;
  for (const Point p : places) {
    longitudes.push_back(p.x);
    box.take_in(p);
  }
  std::sort(longitudes.begin(), longitudes.end());
  double widest = longitudes.front() + 360 - longitudes.back();
  box.low.x = longitudes.front();
  box.high.x = longitudes.back();
  for (std::size_t i = 1; i < longitudes.size(); ++i) {
    const double gap = longitudes[i] - longitudes[i - 1];
    if (gap <= widest) continue;
    widest = gap;
    box.low.x = longitudes[i];
    box.high.x = longitudes[i - 1] + 360;
  }
  return box;
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
  if (metric == Metric::geodesic && !places.empty()) box = shorter_way_round(places);
  const double larger = std::max(box.width(), box.height());
  if (metric == Metric::geodesic) {
    box = larger > 0 ? on_earth(box.grown(larger * margin / 100)) : Box{{-180, -90}, {180, 90}};
  } else {
    box = box.grown(larger * margin / 100);
  }
  if (!(box.width() > 0 && box.height() > 0)) return {};
  const double longest = metric == Metric::geodesic ? 90 : box.width();
  return Basin{"", {{outline(box, longest), {}}}, {}};
}

}  // namespace thiessen
