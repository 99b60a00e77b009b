#include "rainfall/methods/basin_points.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/interrupt.h"
#include "earth/sphere/units.h"
#include "geometry/long_sum.h"
#include "geometry/ring_location.h"

namespace thiessen {
namespace {

struct Edge {
  Point low;
  Point high;

  double x_at(double y) const { return low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x); }
};

/// The edges of a part that rows can cross, from south to north.
std::vector<Edge> edges_of(const Polygon& part) {
  std::vector<Edge> edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Edge edge{ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]};
      if (edge.low.y > edge.high.y) std::swap(edge.low, edge.high);
      if (edge.low.y < edge.high.y) edges.push_back(edge);
    }
  };
  add(part.outer);
  for (const Ring& hole : part.holes) add(hole);
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.low.y < b.low.y; });
  return edges;
}

double area_of(const Ring& ring, const Surface& surface) {
  const double reference = box_of(ring).low.y;
  LongSum sum;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum.add(surface.under(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], reference));
  return std::abs(sum.value());
}

double area_of(const Polygon& part, const Surface& surface) {
  LongSum sum;
  sum.add(area_of(part.outer, surface));
  for (const Ring& hole : part.holes) sum.add(-area_of(hole, surface));
  return std::max(0.0, sum.value());
}

/// The latitude that halves a strip's area on a sphere: cos(c) = cos(middle) cos(half), where c is
/// the distance from the nearer pole.
double halving_latitude(double south, double north) {
  const double middle = south + (north - south) / 2;
  const double from_pole = (90 - std::abs(middle)) * degree;
  const double half = (north - south) / 2 * degree;
  const double a = std::sin(from_pole / 2);
  const double b = std::sin(half / 2);
  const double c = 2 * std::asin(std::sqrt(a * a + std::cos(from_pole) * b * b));
  return std::clamp(middle - std::copysign((c - from_pole) / degree, middle), south, north);
}

/// Divides the box of a part into strips of equal height.
class Rows {
 public:
  Rows(const Box& box, std::size_t count, const Yardstick& yardstick, const Surface& surface)
      : south_(box.low.y),
        height_(box.height()),
        count_(count),
        yardstick_(yardstick),
        surface_(surface) {}

  std::size_t count() const { return count_; }
  /// The latitude or y at which the row of a strip runs.
  double at(std::size_t row) const {
    return yardstick_.metric == Metric::geodesic
               ? halving_latitude(south_of(row), south_of(row + 1))
               : south_ +
                     height_ * ((static_cast<double>(row) + 0.5) / static_cast<double>(count_));
  }
  /// The area of a strip for each unit of x.
  double width_of(std::size_t row) const {
    const double north = south_of(row + 1);
    return surface_.under({0, north}, {1, north}, south_of(row));
  }

 private:
  double south_of(std::size_t row) const {
    return south_ + height_ * (static_cast<double>(row) / static_cast<double>(count_));
  }

  double south_;
  double height_;
  std::size_t count_;
  const Yardstick& yardstick_;
  const Surface& surface_;
};

/// Calls take(row, crossings) for every row that edges cross. The part lies between the first and
/// the second crossing, between the third and the fourth, and so on.
template <typename Take>
void for_each_row(const std::vector<Edge>& edges, const Rows& rows, Take&& take) {
  struct Crossing {
    double x;
    std::size_t edge;
  };
  const auto by_x = [](const Crossing& a, const Crossing& b) { return a.x < b.x; };
  std::vector<Crossing> crossings;  // of the row before, hence nearly in order
  std::size_t next = 0;
  for (std::size_t row = 0; row < rows.count(); ++row) {
    throw_if_interrupted();
    const double y = rows.at(row);
    for (; next < edges.size() && edges[next].low.y < y; ++next) crossings.push_back({0, next});
    std::erase_if(crossings, [&](const Crossing& c) { return edges[c.edge].high.y < y; });
    for (Crossing& c : crossings) c.x = edges[c.edge].x_at(y);
    if (!std::is_sorted(crossings.begin(), crossings.end(), by_x))
      std::sort(crossings.begin(), crossings.end(), by_x);
    if (!crossings.empty()) take(row, std::as_const(crossings));
  }
}

/// Sets a point each time that an equal share of the area lies behind.
class Pacing {
 public:
  explicit Pacing(double share) : share_(share), next_(share / 2) {}

  /// Goes straight from one point to another over ground of this area.
  void go(double area, Point from, Point to) {
    const double begin = gone_.value();
    gone_.add(area);
    const double end = gone_.value();
    while (next_ < end && area > 0) {
      const double along = std::clamp((next_ - begin) / area, 0.0, 1.0);
      points_.push_back({from.x + along * (to.x - from.x), from.y});
      next_ = (static_cast<double>(points_.size()) + 0.5) * share_;
    }
  }
  std::vector<Point> take_points() && { return std::move(points_); }

 private:
  double share_;
  double next_;
  LongSum gone_;
  std::vector<Point> points_;
};

class BasinPoints {
 public:
  BasinPoints(const Basin& basin, const Yardstick& yardstick, std::size_t count)
      : yardstick_(yardstick), surface_(yardstick.surface()) {
    LongSum sum;
    for (const Polygon& part : basin.shape) {
      areas_.push_back(area_of(part, *surface_));
      sum.add(areas_.back());
    }
    share_ = sum.value() / static_cast<double>(count);
  }

  std::vector<Point> points(const Basin& basin) const {
    Pacing pacing(share_);
    for (std::size_t i = 0; i < basin.shape.size(); ++i) {
      if (areas_[i] > 0) go_over(basin.shape[i], areas_[i], pacing);
    }
    return std::move(pacing).take_points();
  }

 private:
  /// The number of rows for a part: as many as make the ground of a point square. Where the part
  /// fills little of its box there are more, so that two rows cross it wherever it is.
  std::size_t rows_for(const Box& box, double area) const {
    constexpr double metres_a_degree = mean_radius * degree;
    const double side =
        std::sqrt(share_) /
        (yardstick_.metric == Metric::geodesic ? metres_a_degree : std::sqrt(yardstick_.unit_area));
    const double filled = area / surface_->under({box.low.x, box.high.y}, box.high, box.low.y);
    const double wanted = std::max(std::round(box.height() / side), std::ceil(2 / filled));
    const double most = 4 * std::ceil(area / share_) + 4;
    return static_cast<std::size_t>(std::clamp(wanted, 1.0, most));
  }

  void go_over(const Polygon& part, double area, Pacing& pacing) const {
    const std::vector<Edge> edges = edges_of(part);
    const Box box = box_of(part.outer);
    const Rows rows(box, rows_for(box, area), yardstick_, *surface_);
    LongSum crossed;
    for_each_row(edges, rows, [&](std::size_t row, const auto& crossings) {
      LongSum length;
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        length.add(crossings[i + 1].x - crossings[i].x);
      crossed.add(length.value() * rows.width_of(row));
    });
    if (!(crossed.value() > 0)) {
      const Point first = *std::min_element(part.outer.begin(), part.outer.end());
      return pacing.go(area, first, first);
    }
    const double scale = area / crossed.value();
    bool eastward = true;
    for_each_row(edges, rows, [&](std::size_t row, const auto& crossings) {
      const double y = rows.at(row);
      const double width = rows.width_of(row) * scale;
      const std::size_t chords = crossings.size() / 2;
      for (std::size_t k = 0; k < chords; ++k) {
        const std::size_t i = 2 * (eastward ? k : chords - 1 - k);
        Point from{crossings[i].x, y};
        Point to{crossings[i + 1].x, y};
        if (!eastward) std::swap(from, to);
        pacing.go(std::abs(to.x - from.x) * width, from, to);
      }
      eastward = !eastward;
    });
  }

  const Yardstick& yardstick_;
  std::unique_ptr<Surface> surface_;
  std::vector<double> areas_;  // by part
  double share_ = 0;           // the area that a point stands for
};

}  // namespace

std::vector<Point> basin_points(const Basin& basin, const Yardstick& yardstick, std::size_t count) {
  return BasinPoints(basin, yardstick, count).points(basin);
}

}  // namespace thiessen
