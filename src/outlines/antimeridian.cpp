#include "outlines/antimeridian.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "basin/basin.h"
#include "basin/ring_linking.h"
#include "geometry/ring_location.h"

namespace thiessen {
namespace {

/// Counts how often the edges along a line cover each stretch of it: upward edges minus downward
/// ones.
class Cover {
 public:
  void add(double from, double to, int times) {
    change_[from] += times;
    change_[to] -= times;
  }
  /// Makes edges begin and end at a place on the line.
  void part_at(double at) { change_[at] += 0; }

  template <typename Take>
  void for_each_edge(const Take& take) const {
    int times = 0;
    for (auto at = change_.begin(); at != change_.end() && std::next(at) != change_.end(); ++at) {
      times += at->second;
      const double low = at->first;
      const double high = std::next(at)->first;
      for (int i = 0; i < times; ++i) take(low, high);
      for (int i = times; i < 0; ++i) take(high, low);
    }
  }

 private:
  std::map<double, int> change_;
};

/// A ring's vertex, with the turn of longitude on which it lies. Strip k of the turns lies between
/// meridians k - 1 and k, which are both the antimeridian.
struct Vertex {
  Point point;
  int turn;

  bool on_antimeridian() const { return std::abs(point.x) == 180; }
  int meridian() const { return point.x > 0 ? turn : turn - 1; }
  /// The vertex's position in a strip that it lies in or on the side of.
  Point in_strip(int strip) const {
    if (!on_antimeridian()) return point;
    return {meridian() == strip ? 180.0 : -180.0, point.y};
  }
  /// Degrees from a meridian eastward to the vertex.
  double east_of(int meridian) const {
    return turn <= meridian ? point.x - 180 + 360 * (turn - meridian)
                            : point.x + 180 + 360 * (turn - meridian - 1);
  }
};

class Cutting {
 public:
  /// `side` is 1 for an outer ring and -1 for a hole.
  void add(const WindingRing& ring, int side) {
    started_ = false;
    if (ring.holds_south) inside_at_south_ += side;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex from{ring.points[i], ring.turns[i]};
      const Vertex to{ring.points[i + 1 < ring.size() ? i + 1 : 0], ring.turn_at(i + 1)};
      add_edge(from, to, ring.bulges.empty() ? 0 : ring.bulges[i]);
    }
    if (started_) pass(first_strip_ + ring.winding, first_latitude_);
    has_bulges_ = has_bulges_ || !ring.bulges.empty();
  }

  CurvedShape shape() && {
    add_seam();
    east_.for_each_edge([&](double from, double to) {
      edges_.push_back({{180, from}, {180, to}});
    });
    west_.for_each_edge([&](double from, double to) {
      edges_.push_back({{-180, from}, {-180, to}});
    });
    north_.for_each_edge([&](double from, double to) { edges_.push_back({{from, 90}, {to, 90}}); });
    south_.for_each_edge([&](double from, double to) {
      edges_.push_back({{from, -90}, {to, -90}});
    });
    cancel_opposite_edges();
    CurvedShape result{link_rings(std::move(edges_)), {}};
    if (has_bulges_) find_bulges(result);
    return result;
  }

 private:
  static int strip_at_start(const Vertex& from, int direction) {
    if (!from.on_antimeridian()) return from.turn;
    return direction > 0 ? from.meridian() + 1 : from.meridian();
  }

  void add_edge(const Vertex& from, const Vertex& to, double bulge) {
    const double gain = to.point.x - from.point.x + 360 * (to.turn - from.turn);
    if (gain == 0 && from.point.y == to.point.y) return;
    // An edge along the antimeridian belongs to the strip on the side of the interior, its left.
    const int direction = gain != 0 ? (gain > 0 ? 1 : -1) : (to.point.y > from.point.y ? -1 : 1);
    int strip = strip_at_start(from, direction);
    const int last = gain == 0 ? strip : strip_at_start(to, -direction);
    pass(strip, from.point.y);
    Point start = from.in_strip(strip);
    double begin = 0;
    for (; strip != last; strip += direction) {
      const int meridian = direction > 0 ? strip : strip - 1;
      const double latitude = crossing(from, to, meridian);
      const double along = from.east_of(meridian) / (from.east_of(meridian) - to.east_of(meridian));
      emit(start, {direction > 0 ? 180.0 : -180.0, latitude},
           bulge * (bulge_share(along) - bulge_share(begin)));
      pass(strip + direction, latitude);
      start = {direction > 0 ? -180.0 : 180.0, latitude};
      begin = along;
    }
    emit(start, to.in_strip(last), bulge * (1 - bulge_share(begin)));
  }

  /// The latitude at which an edge crosses a meridian; it is the same from either end.
  static double crossing(Vertex west, Vertex east, int meridian) {
    double to_west = west.east_of(meridian);
    double to_east = east.east_of(meridian);
    if (to_east < to_west) {
      std::swap(west, east);
      std::swap(to_west, to_east);
    }
    const double latitude =
        west.point.y - to_west * ((east.point.y - west.point.y) / (to_east - to_west));
    const auto [low, high] = std::minmax(west.point.y, east.point.y);
    return std::clamp(latitude, low, high);
  }

  /// Follows the ring into a strip, which may be another one than before.
  void pass(int strip, double latitude) {
    if (!started_) {
      started_ = true;
      first_strip_ = strip;
      first_latitude_ = latitude;
    } else if (strip != strip_) {
      crossings_[latitude] += strip - strip_;
    }
    strip_ = strip;
  }

  void emit(Point from, Point to, double bulge) {
    if (from == to) return;
    if (bulge != 0) bulges_[{from, to}] += bulge;
    for (const Point point : {from, to}) {
      if (point.x == 180) east_.part_at(point.y);
      if (point.x == -180) west_.part_at(point.y);
      if (point.y == 90) north_.part_at(point.x);
      if (point.y == -90) south_.part_at(point.x);
    }
    if (from.x == to.x && std::abs(from.x) == 180) {
      (from.x > 0 ? east_ : west_).add(from.y, to.y, 1);
    } else if (from.y == to.y && std::abs(from.y) == 90) {
      (from.y > 0 ? north_ : south_).add(from.x, to.x, 1);
    } else {
      edges_.push_back({from, to});
    }
  }

  // Adds edges along the antimeridian where the interior crosses it. The interior lies north of an
  // eastward crossing, and the exterior north of a westward one.
  void add_seam() {
    int inside = inside_at_south_;
    south_.add(-180, 180, inside);
    double from = -90;
    for (const auto& [latitude, step] : crossings_) {
      add_seam(from, latitude, inside);
      from = latitude;
      inside += step;
    }
    add_seam(from, 90, inside);
    north_.add(180, -180, inside);
  }

  void add_seam(double from, double to, int times) {
    if (times == 0) return;
    east_.add(from, to, times);
    west_.add(to, from, times);
  }

  // Takes out edges that lie on each other in opposite directions. They come from a file's own
  // seam, drawn at a longitude other than the antimeridian.
  void cancel_opposite_edges() {
    const auto key = [](const DirectedEdge& edge) { return std::minmax(edge.from, edge.to); };
    std::stable_sort(edges_.begin(), edges_.end(),
                     [&](const DirectedEdge& a, const DirectedEdge& b) { return key(a) < key(b); });
    std::vector<DirectedEdge> kept;
    for (const DirectedEdge& edge : edges_) {
      if (!kept.empty() && kept.back().from == edge.to && kept.back().to == edge.from) {
        kept.pop_back();
      } else {
        kept.push_back(edge);
      }
    }
    edges_ = std::move(kept);
  }

  void find_bulges(CurvedShape& result) const {
    const auto add = [&](const Ring& ring) {
      std::vector<double>& bulges = result.bulges.emplace_back();
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto found = bulges_.find({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]});
        bulges.push_back(found == bulges_.end() ? 0 : found->second);
      }
    };
    for (const Polygon& polygon : result.shape) {
      add(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), add);
    }
  }

  int inside_at_south_ = 0;
  std::vector<DirectedEdge> edges_;
  std::map<std::pair<Point, Point>, double> bulges_;
  bool has_bulges_ = false;
  Cover east_;  // the side of the antimeridian at 180
  Cover west_;
  Cover north_;  // along the north pole
  Cover south_;
  std::map<double, int> crossings_;  // by latitude: eastward ones minus westward ones

  bool started_ = false;  // whether the ring at hand has begun
  int strip_ = 0;
  int first_strip_ = 0;
  double first_latitude_ = 0;
};

bool within_one_turn(const Polygon& polygon) {
  const Box box = box_of(polygon.outer);
  return box.empty() || (box.low.x >= -180 && box.high.x <= 180);
}

}  // namespace

void append(CurvedShape part, CurvedShape& into) {
  std::move(part.shape.begin(), part.shape.end(), std::back_inserter(into.shape));
  std::move(part.bulges.begin(), part.bulges.end(), std::back_inserter(into.bulges));
}

CurvedShape cut_at_antimeridian(std::span<const WindingRing> rings) {
  Cutting cutting;
  for (std::size_t i = 0; i < rings.size(); ++i) cutting.add(rings[i], i == 0 ? 1 : -1);
  return std::move(cutting).shape();
}

void cut_at_antimeridian(CurvedShape& shape) {
  if (std::all_of(shape.shape.begin(), shape.shape.end(), within_one_turn)) return;
  CurvedShape result;
  auto bulges = shape.bulges.begin();
  for (Polygon& polygon : shape.shape) {
    const auto count =
        static_cast<std::ptrdiff_t>(shape.bulges.empty() ? 0 : polygon.holes.size() + 1);
    if (within_one_turn(polygon)) {
      result.shape.push_back(std::move(polygon));
      result.bulges.insert(result.bulges.end(), bulges, bulges + count);
    } else {
      std::vector<WindingRing> rings = {ring_as_written(polygon.outer)};
      for (const Ring& hole : polygon.holes) rings.push_back(ring_as_written(hole));
      for (std::ptrdiff_t i = 0; i < count; ++i)
        rings[static_cast<std::size_t>(i)].bulges = *(bulges + i);
      append(cut_at_antimeridian(rings), result);
    }
    bulges += count;
  }
  shape = std::move(result);
}

std::vector<std::vector<Point>> cut_at_antimeridian(std::span<const Point> line) {
  const auto turn_of = [](double longitude) { return std::floor((longitude + 180) / 360); };
  std::vector<std::vector<Point>> pieces;
  double turn = 0;
  const auto is_within_turn = [&](Point p) { return std::abs(p.x - 360 * turn) <= 180; };
  const auto add = [&](Point from, Point to) {
    const double before = turn;
    if (!is_within_turn(from) || !is_within_turn(to)) turn = turn_of(from.x + (to.x - from.x) / 2);
    if (pieces.empty() || turn != before) pieces.push_back({{from.x - 360 * turn, from.y}});
    pieces.back().push_back({to.x - 360 * turn, to.y});
  };
  for (std::size_t i = 1; i < line.size(); ++i) {
    Point from = line[i - 1];
    const Point to = line[i];
    const bool eastward = from.x < to.x;
    // The antimeridians strictly between the two ends, in the order in which they are met.
    double seam = eastward ? 360 * turn_of(from.x) + 180 : 360 * turn_of(from.x) - 180;
    if (!eastward && seam == from.x) seam -= 360;
    for (; eastward ? seam < to.x : seam > to.x; seam += eastward ? 360 : -360) {
      const double share = (seam - line[i - 1].x) / (to.x - line[i - 1].x);
      const Point met{seam, line[i - 1].y + share * (to.y - line[i - 1].y)};
      add(from, met);
      from = met;
    }
    add(from, to);
  }
  return pieces;
}

}  // namespace thiessen
