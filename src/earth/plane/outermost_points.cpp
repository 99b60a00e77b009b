#include "earth/plane/outermost_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace thiessen {
namespace {

constexpr std::size_t strips = 512;
constexpr std::size_t sectors = 720;  // of half a degree, in which a gap is sought

bool at_pole(Point p) {
  return std::abs(p.y) >= 90;
}

std::size_t sector_of(double longitude) {
  const double turned = std::remainder(longitude, 360) + 180;
  return std::min(static_cast<std::size_t>(turned * 2), sectors - 1);
}

/// The longitude in the middle of the widest gap; nothing where every sector has a point.
std::optional<double> middle_of_gap(std::span<const Point> points) {
  std::vector<bool> taken(sectors, false);
  for (const Point p : points) {
    if (!at_pole(p)) taken[sector_of(p.x)] = true;
  }
  std::size_t widest = 0;
  std::size_t end = 0;
  std::size_t empty = 0;
  for (std::size_t i = 0; i < 2 * sectors; ++i) {
    empty = taken[i % sectors] ? 0 : empty + 1;
    if (empty <= widest || widest == sectors) continue;
    widest = empty;
    end = i;
  }
  if (widest < 2) return std::nullopt;
  const double width = static_cast<double>(std::min(widest, sectors)) / 2;
  return static_cast<double>(end + 1) / 2 - width / 2 - 180;
}

/// The two outermost points of a strip.
struct Ends {
  std::optional<Point> low;
  std::optional<Point> high;

  // Ties go to the lesser point, so that the order of points does not matter.
  void see(Point p, double Point::*along) {
    if (!low || p.*along < (*low).*along || (p.*along == (*low).*along && p < *low)) low = p;
    if (!high || p.*along > (*high).*along || (p.*along == (*high).*along && p < *high)) high = p;
  }
};

std::size_t strip_of(double at, double low, double width) {
  if (!(width > 0)) return 0;
  const double share = (at - low) / width * static_cast<double>(strips);
  return std::min(static_cast<std::size_t>(std::max(share, 0.0)), strips - 1);
}

/// Longitudes that run on from the middle of the gap.
class RunningOn {
 public:
  explicit RunningOn(std::optional<double> gap) : from_(gap.value_or(-180)) {}
  double operator()(double longitude) const {
    const double on = std::remainder(longitude - from_, 360);
    return from_ + (on < 0 ? on + 360 : on);
  }

 private:
  double from_;
};

}  // namespace

std::optional<OutermostPoints> outermost_points(std::span<const Point> points) {
  if (points.empty()) return std::nullopt;
  const auto gap = middle_of_gap(points);
  const RunningOn run_on(gap);
  OutermostPoints outermost;
  double east = -1e9;
  outermost.west = 1e9;
  outermost.south = 90;
  outermost.north = -90;
  for (const Point p : points) {
    outermost.south = std::min(outermost.south, p.y);
    outermost.north = std::max(outermost.north, p.y);
    if (at_pole(p)) continue;
    outermost.west = std::min(outermost.west, run_on(p.x));
    east = std::max(east, run_on(p.x));
  }
  if (east < outermost.west) outermost.west = east = 0;  // all stand at poles
  outermost.width = gap ? east - outermost.west : 360;
  const double middle = outermost.west + outermost.width / 2;
  std::vector<Ends> by_longitude(strips);
  std::vector<Ends> by_latitude(strips);
  for (Point p : points) {
    p.x = at_pole(p) ? middle : run_on(p.x);
    by_longitude[strip_of(p.x, outermost.west, outermost.width)].see(p, &Point::y);
    by_latitude[strip_of(p.y, outermost.south, outermost.north - outermost.south)].see(p,
                                                                                       &Point::x);
  }
  for (const auto* ends : {&by_longitude, &by_latitude}) {
    for (const Ends& strip : *ends) {
      if (!strip.low) continue;
      outermost.points.push_back(*strip.low);
      outermost.points.push_back(*strip.high);
    }
  }
  std::sort(outermost.points.begin(), outermost.points.end());
  outermost.points.erase(std::unique(outermost.points.begin(), outermost.points.end()),
                         outermost.points.end());
  return outermost;
}

}  // namespace thiessen
