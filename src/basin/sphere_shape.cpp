#include "basin/sphere_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "earth/conformal_sphere.h"

namespace thiessen {
namespace {

Point between(Point a, Point b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// The radius of the disc round its middle that holds a box in longitude and latitude.
double reach_of(const Box& box, Direction centre) {
  constexpr double widest = 90;  // degrees: up to there a corner is the farthest point
  if (box.width() > widest) return std::numbers::pi;
  double reach = 0;
  for (const Point corner :
       {box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}})
    reach = std::max(reach, 2 * std::asin(std::min(1.0, length(on_sphere(corner) - centre) / 2)));
  return reach;
}

}  // namespace

/// Makes rings of great circles of rings in longitude and latitude.
class SphereShape::Simplifying {
 public:
  Simplifying(Direction centre, double size, std::span<const Point> bends)
      : chart_(centre), surface_(chart_), finest_(1e-5 * size), bends_(bends) {}

  SphereRing ring(const Ring& ring, const std::vector<double>* bulges) {
    keeps_all_ = false;
    const auto kept =
        std::count_if(ring.begin(), ring.end(), [this](Point p) { return !is_bend(p); });
    keeps_all_ = kept < 3;
    const std::size_t first = first_kept(ring);
    result_ = {};
    begin(ring[first]);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t from = (first + i) % ring.size();
      const std::size_t to = (from + 1) % ring.size();
      add_edge(ring[from], ring[to], bulges == nullptr ? 0 : (*bulges)[from],
               i + 1 < ring.size() && is_bend(ring[to]));
    }
    result_.corners.pop_back();  // the first again
    result_.bulges.pop_back();
    return std::move(result_);
  }

 private:
  bool is_bend(Point p) const {
    return !keeps_all_ && std::binary_search(bends_.begin(), bends_.end(), p);
  }

  static double to_right(Point from, Point to, Point p) {
    const Point way{to.x - from.x, to.y - from.y};
    return ((p.x - from.x) * way.y - (p.y - from.y) * way.x) / std::hypot(way.x, way.y);
  }

  std::size_t first_kept(const Ring& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!is_bend(ring[i])) return i;
    }
    return 0;
  }

  void begin(Point corner) {
    const Direction direction = on_sphere(corner);
    result_.corners.push_back(direction);
    result_.bulges.push_back(0);
    chord_from_ = last_ = chart_.project(direction);
    along_bends_ = 0;
  }

  // Straight in longitude and latitude; where its end is to be left out the chord goes on.
  void add_edge(Point a, Point b, double bulge, bool goes_on) {
    if (a == b) return;
    const std::array<double, 3> shares{0.25, 0.5, 0.75};
    const Direction end = on_sphere(b);
    const Point to = chart_.project(end);
    double farthest = 0;
    for (const double share : shares) {
      farthest = std::max(
          farthest, std::abs(to_right(last_, to, chart_.project(on_sphere(between(a, b, share))))));
    }
    constexpr double most_pieces = 1000;
    const int pieces =
        static_cast<int>(std::clamp(std::ceil(std::sqrt(farthest / finest_)), 1.0, most_pieces));
    for (int i = 1; i <= pieces; ++i) {
      const double before = (i - 1.0) / pieces;
      const double after = static_cast<double>(i) / pieces;
      const Point piece_end = i == pieces ? b : between(a, b, after);
      add_piece(between(a, b, before), piece_end, i == pieces && goes_on,
                bulge * (bulge_share(after) - bulge_share(before)));
    }
  }

  void add_piece(Point a, Point b, bool goes_on, double bulge) {
    const Direction end = on_sphere(b);
    const Point to = chart_.project(end);
    if (to == last_) return;
    // By G. Boole's rule.
    double mean = 0;
    for (const auto& [share, weight] :
         {std::pair(0.25, 32. / 90), std::pair(0.5, 12. / 90), std::pair(0.75, 32. / 90)})
      mean += weight * to_right(last_, to, chart_.project(on_sphere(between(a, b, share))));
    const double length = std::hypot(to.x - last_.x, to.y - last_.y);
    result_.bulges.back() += bulge + mean * length * chart_.unit_area(between(last_, to, 0.5));
    along_bends_ -= surface_.under(last_, to, 0);
    last_ = to;
    if (goes_on) return;
    result_.bulges.back() += along_bends_ + surface_.under(chord_from_, to, 0);
    result_.corners.push_back(end);
    result_.bulges.push_back(0);
    chord_from_ = to;
    along_bends_ = 0;
  }

  GnomonicChart chart_;
  ChartSurface surface_;
  double finest_;
  std::span<const Point> bends_;
  bool keeps_all_ = false;  // where too few would be left for a ring
  SphereRing result_;
  Point chord_from_;
  Point last_;
  double along_bends_ = 0;  // the area from the centre to what the chord stands for
};

SphereShape::SphereShape(const Basin& ground, std::span<const Point> bends) {
  for (const Polygon& part : ground.shape) {
    for (const Point p : part.outer) box_.take_in(p);
  }
  centre_ = on_sphere(box_.centre());
  reach_ = reach_of(box_, centre_);
  if (reach_ > farthest) return;
  Simplifying simplifying(centre_, reach_, bends);
  std::size_t ring_number = 0;
  const auto ring = [&](const Ring& all) {
    return simplifying.ring(all, ground.bulges.empty() ? nullptr : &ground.bulges[ring_number++]);
  };
  for (const Polygon& part : ground.shape) {
    parts_.push_back({ring(part.outer), {}});
    for (const Ring& hole : part.holes) parts_.back().holes.push_back(ring(hole));
  }
}

Basin SphereShape::in_chart(const GnomonicChart& chart) const {
  Basin basin;
  const auto add = [&](const SphereRing& ring) {
    Ring projected;
    projected.reserve(ring.corners.size());
    for (const Direction corner : ring.corners) projected.push_back(chart.project(corner));
    basin.bulges.push_back(ring.bulges);
    return projected;
  };
  basin.shape.reserve(parts_.size());
  for (const Part& part : parts_) {
    Polygon polygon;
    polygon.outer = add(part.outer);
    for (const SphereRing& hole : part.holes) polygon.holes.push_back(add(hole));
    basin.shape.push_back(std::move(polygon));
  }
  return basin;
}

}  // namespace thiessen
