#include "earth/cells/edge_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/interrupt.h"
#include "earth/area/ellipsoid_area.h"
#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/units.h"

namespace thiessen {
namespace {

// These are all in radians.
constexpr double longest_piece = std::numbers::pi / 8;
constexpr double longest_fit = 0.2;
constexpr double longest_chord = 0.02;
constexpr double shortest_chord = 1e-10;

/// The difference of two longitudes the short way round, from one that is less than a turn and a
/// half.
double short_way(double difference) {
  if (difference > 180) return difference - 360;
  if (difference < -180) return difference + 360;
  return difference;
}

/// The way from a to b in metres to the east and to the north, near a latitude.
struct Way {
  Way(Point a, Point b, double cosine)
      : east(short_way(b.x - a.x) * cosine * degree * mean_radius),
        north((b.y - a.y) * degree * mean_radius) {}
  double east;
  double north;
};

/// How far, in metres, an edge's middle lies from the middle of its chord.
double bulge(Point start, Point middle, Point end) {
  const double cosine = std::cos(middle.y * degree);
  const Way before(start, middle, cosine);
  const Way after(middle, end, cosine);
  return std::hypot(after.east - before.east, after.north - before.north) / 2;
}

/// How far, in metres, an edge's middle lies to the right of the line of its chord. The sign tells
/// an edge that bends both ways, as one does that crosses the equator, from one that is even.
double sagitta(Point start, Point middle, Point end) {
  const double cosine = std::cos(middle.y * degree);
  const Way before(start, middle, cosine);
  const Way after(middle, end, cosine);
  const double east = before.east + after.east;
  const double north = before.north + after.north;
  const double length = std::sqrt(east * east + north * north);
  if (length == 0) return std::hypot(before.east, before.north);
  return (before.east * after.north - before.north * after.east) / length;
}

/// How a piece of an edge bends: how far, in metres, its middle and those of its halves lie from
/// their chords.
struct Bend {
  double whole;
  double first;
  double last;

  double most() const { return std::max(std::abs(first), std::abs(last)); }
  /// Whether the curve is as strong in one half as in the other.
  bool is_even() const {
    return std::abs(first - last) <= most() / 2 && std::abs(whole) <= 5 * most();
  }
  bool is_fine(double tolerance) const {
    return std::max(std::abs(whole), 4 * most()) <= tolerance;
  }
  /// How many chords an even piece takes. A piece that bulges by b bulges by b / n^2 where it is
  /// divided into n. Near one of its ends the curve is stronger still, by half the difference
  /// between the halves.
  int chords(double tolerance) const {
    if (is_fine(tolerance)) return 1;
    const double at_an_end = 1.02 * (most() + std::abs(first - last) / 2);
    return static_cast<int>(std::ceil(2 * std::sqrt(at_an_end / tolerance)));
  }
};

/// How many times the accuracy of vertices the ends of chords may be off.
constexpr double ends_are_right_to = 10;

/// The latitude of the pole that lies within so many metres of a point, or 0.
double pole_at(Point p, double metres) {
  const double off = (90 - std::abs(p.y)) * degree * mean_radius;
  return off <= metres ? std::copysign(90, p.y) : 0;
}

/// Where an edge passes a pole: its angle, and the pole's latitude.
struct PolePassage {
  double angle;
  double pole;
};

/// The poles within `near` radians of an edge's great circle, strictly between two angles. The
/// places are then at one latitude, and the edge is the great circle.
std::vector<PolePassage> poles_between(const BisectorArc& arc, double from, double to,
                                       double near) {
  std::vector<PolePassage> passages;
  if (!(std::abs(arc.forward().z) <= near)) return passages;
  for (const double pole : {-90.0, 90.0}) {
    double angle = arc.angle_of({0, 0, std::copysign(1, pole)});
    angle += 2 * std::numbers::pi * std::ceil((from - angle) / (2 * std::numbers::pi));
    if (angle - from > shortest_chord && to - angle > shortest_chord)
      passages.push_back({angle, pole});
  }
  std::sort(passages.begin(), passages.end(),
            [](const PolePassage& a, const PolePassage& b) { return a.angle < b.angle; });
  return passages;
}

/// The length of the frame's longer side, in degrees of a great circle.
double size_of(const Box& frame) {
  const double widest = std::clamp(0.0, frame.low.y, frame.high.y);
  return std::max({frame.height(), frame.width() * std::cos(widest * degree), 1e-7});
}

}  // namespace

bool may_come_near(const Box& frame, Point centre, double radius) {
  const double stretch = 1.01;  // more than latitudes stretch from the sphere to the ellipsoid
  const double south = centre.y - stretch * radius;
  const double north = centre.y + stretch * radius;
  if (south > frame.high.y || north < frame.low.y) return false;
  if (north >= 89.5 || south <= -89.5) return true;
  const double widest = std::max(std::abs(south), std::abs(north)) * degree;
  const double east_west = stretch * radius / std::cos(widest);
  const double distance = std::abs(short_way(std::remainder(centre.x - frame.centre().x, 360)));
  return distance <= east_west + frame.width() / 2;
}

EdgeDrawing::EdgeDrawing(const Box& frame, double tolerance, std::uint32_t first_node)
    : frame_(frame),
      frame_size_(size_of(frame)),
      longitudes_(frame),
      tolerance_(tolerance),
      first_node_(first_node) {}

void EdgeDrawing::draw(const GeodesicBisector& edge, EdgePoint from, EdgePoint to, PlaceIndex left,
                       PlaceIndex right) {
  left_ = left;
  right_ = right;
  const double near = ends_are_right_to * edge.accuracy();
  std::vector<PolePassage> passages =
      poles_between(edge.arc(), from.angle, to.angle, near / mean_radius);
  std::erase_if(passages, [this](const PolePassage& passage) { return !reaches(passage.pole); });
  const double first_pole = pole_at(from.position, near);
  const double last_pole = pole_at(to.position, near);
  const auto inward = [&](double angle) { return (to.angle - angle) / 4; };
  if (inward(from.angle) > 0 && reaches(first_pole))
    from = end_at_pole(edge, from.angle, inward(from.angle), first_pole);
  for (const PolePassage& passage : passages) {
    const double backward = (from.angle - passage.angle) / 4;
    draw_between_poles(edge, from, end_at_pole(edge, passage.angle, backward, passage.pole));
    from = end_at_pole(edge, passage.angle, inward(passage.angle), passage.pole);
  }
  if (inward(from.angle) > 0 && reaches(last_pole))
    to = end_at_pole(edge, to.angle, -inward(from.angle), last_pole);
  draw_between_poles(edge, from, to);
}

/// Whether the frame reaches a pole, given as a latitude. It may say yes where it only comes near.
bool EdgeDrawing::reaches(double pole) const {
  constexpr double near = 1e-3;  // degrees
  return pole != 0 && thiessen::may_come_near(frame_, {frame_.centre().x, pole}, near);
}

// The end of an edge at a pole, at the longitude of the edge's point a little way inward.
EdgePoint EdgeDrawing::end_at_pole(const GeodesicBisector& edge, double angle, double inward,
                                   double pole) {
  constexpr double farthest_inward = 1e-4;  // radians
  const double way = std::clamp(inward, -farthest_inward, farthest_inward);
  const Point at{point_at(edge, angle + way).position.x, pole};
  const std::uint32_t node = new_node(at);
  const std::uint32_t beyond = new_node({at.x, pole + std::copysign(1, pole)});
  if (inward < 0) {
    add_chord(node, beyond, 0);
  } else {
    add_chord(beyond, node, 0);
  }
  return {angle, node, at};
}

void EdgeDrawing::draw_between_poles(const GeodesicBisector& edge, EdgePoint from, EdgePoint to) {
  const auto [first, last] = stretch_near(edge, from.angle, to.angle);
  if (first == last) return;
  const int pieces = static_cast<int>(std::ceil((last - first) / longest_piece));
  const auto point = [&, first = first, last = last](int i) {
    const double angle = i == pieces ? last : first + (last - first) * i / pieces;
    return angle == from.angle ? from : angle == to.angle ? to : point_at(edge, angle);
  };
  EdgePoint start = point(0);
  for (int i = 1; i <= pieces; ++i) {
    EdgePoint end = point(i);
    draw_piece(edge, start, end);
    start = end;
  }
}

// The part of an edge that is left when halves far from the frame have been taken off at its ends.
std::pair<double, double> EdgeDrawing::stretch_near(const GeodesicBisector& edge, double from,
                                                    double to) const {
  while (to - from > shortest_chord) {
    const double half = from + (to - from) / 2;
    const bool first = may_come_near(edge, from, half);
    const bool last = may_come_near(edge, half, to);
    if (first && last) break;
    if (!first) from = half;
    if (!last) to = half;
  }
  return {from, to};
}

bool EdgeDrawing::may_come_near(const GeodesicBisector& edge, double from, double to) const {
  const double half = (to - from) / 2;
  const double off = edge.farthest_off(std::max(std::abs(from), std::abs(to)));
  return thiessen::may_come_near(frame_, from_sphere(edge.arc().at(from + half)),
                                 (half + off) / degree);
}

EdgePoint EdgeDrawing::point_at(const GeodesicBisector& edge, double angle) const {
  return {angle, no_node, longitudes_.within(edge.find(angle).position)};
}

EdgePoint EdgeDrawing::point_at(const BisectorOffset& offset, double angle) const {
  return {angle, no_node, longitudes_.within(offset.at(angle))};
}

// Draws a piece of an edge. It is halved until a polynomial stands for it, its chord is near enough
// to it, or all of it is far from the frame.
void EdgeDrawing::draw_piece(const GeodesicBisector& edge, EdgePoint& start, EdgePoint& end) {
  const double half = (end.angle - start.angle) / 2;
  const double angle = start.angle + half;
  if (!may_come_near(edge, start.angle, end.angle)) return;
  if (2 * half <= longest_fit) {
    const auto offset =
        BisectorOffset::fit(edge, start.angle, start.position, end.angle, end.position);
    if (offset) return draw_piece(*offset, start, end);
  }
  throw_if_interrupted();
  const BisectorPoint found = edge.find(angle);
  EdgePoint middle{angle, no_node, longitudes_.within(found.position)};
  // No chord can follow the edge more closely than distances tell where it is.
  const double allowed = std::max(tolerance_, 4 * found.uncertainty * mean_radius);
  const bool fine =
      2 * half <= longest_chord && bulge(start.position, middle.position, end.position) <= allowed;
  if (fine || half < shortest_chord) {
    return draw_chord(start, end, area_beside_chord(start.position, middle.position, end.position));
  }
  draw_piece(edge, start, middle);
  draw_piece(edge, middle, end);
}

// Draws a piece that a polynomial stands for. It gets chords of equal length where the curve is as
// strong in one half as in the other; parts far from the frame are left out of a piece longer than
// the frame.
void EdgeDrawing::draw_piece(const BisectorOffset& offset, EdgePoint& start, EdgePoint& end) {
  const double half = (end.angle - start.angle) / 2;
  EdgePoint middle = point_at(offset, start.angle + half);
  const bool piece_is_long = is_long(half);
  if (piece_is_long && !thiessen::may_come_near(frame_, middle.position, half / degree)) return;
  const Point first_quarter = longitudes_.within(offset.at(start.angle + half / 2));
  const Point last_quarter = longitudes_.within(offset.at(end.angle - half / 2));
  const Bend bend{sagitta(start.position, middle.position, end.position),
                  sagitta(start.position, first_quarter, middle.position),
                  sagitta(middle.position, last_quarter, end.position)};
  if ((piece_is_long || !bend.is_even()) && !bend.is_fine(tolerance_) && half >= shortest_chord) {
    draw_piece(offset, start, middle);
    draw_piece(offset, middle, end);
    return;
  }
  draw_chords(offset, start, end, bend.chords(tolerance_));
}

bool EdgeDrawing::is_long(double half) const {
  return half / degree > frame_size_ / 16;
}

bool EdgeDrawing::may_be_short(Point from, Point to) const {
  return frame_.contains(from) && frame_.contains(to) &&
         std::abs(from.y) <= ShortEdge::highest_latitude &&
         std::abs(to.y) <= ShortEdge::highest_latitude && longitudes_.is_clear_of_cuts(from.x) &&
         longitudes_.is_clear_of_cuts(to.x);
}

bool EdgeDrawing::draw_short(const ShortEdge& edge, EdgePoint start, EdgePoint end, PlaceIndex left,
                             PlaceIndex right) {
  throw_if_interrupted();
  if (is_long(edge.length() / 2)) return false;
  const auto [whole, first, last] = edge.bend();
  const Bend bend{whole, first, last};
  const bool is_fine = bend.is_fine(tolerance_);
  if (!is_fine && !bend.is_even()) return false;
  left_ = left;
  right_ = right;
  const int chords = is_fine ? 1 : bend.chords(tolerance_);
  const double part = 1. / chords;
  EdgePoint from = start;
  for (int i = 1; i <= chords; ++i) {
    EdgePoint to = i == chords ? end : EdgePoint{0, no_node, edge.at(i * part)};
    draw_chord(from, to, edge.area_beside_chord((i - 0.5) * part, part));
    from = to;
  }
  return true;
}

void EdgeDrawing::draw_chords(const BisectorOffset& offset, EdgePoint& start, EdgePoint& end,
                              int chords) {
  throw_if_interrupted();
  EdgePoint before = start;
  for (int i = 1; i <= chords; ++i) {
    EdgePoint& from = i == 1 ? start : before;
    if (i == chords) return draw_chord(from, end, bulge_of(offset, from, end));
    EdgePoint next = point_at(offset, start.angle + (end.angle - start.angle) * i / chords);
    draw_chord(from, next, bulge_of(offset, from, next));
    before = next;
  }
}

// The area between the edge and its chord. Where the Earth's curvature changes along a long chord,
// or the edge bends both ways, it is that of shorter chords and of what lies between these and the
// long one.
double EdgeDrawing::bulge_of(const BisectorOffset& offset, const EdgePoint& start,
                             const EdgePoint& end) const {
  constexpr double longest_parabola = 0.005;  // radians
  const double angle = end.angle - start.angle;
  const int parts = std::max(1, static_cast<int>(std::ceil(angle / longest_parabola)));
  const auto at = [&](double share) { return offset.at(start.angle + angle * share); };
  if (parts == 1) return area_beside_chord(start.position, at(0.5), end.position);
  const double reference = start.position.y;
  const auto on_turn = [&](Point p) {
    return Point{start.position.x + short_way(std::remainder(p.x - start.position.x, 360)), p.y};
  };
  Point before = start.position;
  double bulge = area_under(before, on_turn(end.position), reference);
  for (int i = 1; i <= parts; ++i) {
    const Point next = on_turn(i == parts ? end.position : at(static_cast<double>(i) / parts));
    bulge -= area_under(before, next, reference);
    bulge += area_beside_chord(before, at((i - 0.5) / parts), next);
    before = next;
  }
  return bulge;
}

void EdgeDrawing::add_chord(std::uint32_t from, std::uint32_t to, double bulge) {
  chords_.push_back({from, to, left_, right_});
  bulges_.push_back(bulge);
}

void EdgeDrawing::draw_chord(EdgePoint& start, EdgePoint& end, double bulge) {
  if (start.node == no_node) start.node = new_node(start.position);
  if (end.node == no_node) end.node = new_node(end.position);
  if (start.node != end.node) add_chord(start.node, end.node, bulge);
}

void EdgeDrawing::add_to(Diagram& diagram) const {
  throw_if_interrupted();
  const auto shift = static_cast<std::uint32_t>(diagram.nodes.size()) - first_node_;
  const auto shifted = [&](std::uint32_t node) { return node < first_node_ ? node : node + shift; };
  diagram.nodes.insert(diagram.nodes.end(), nodes_.begin(), nodes_.end());
  for (const Chord& chord : chords_) {
    diagram.chords.push_back({shifted(chord.from), shifted(chord.to), chord.left, chord.right});
  }
  diagram.bulges.insert(diagram.bulges.end(), bulges_.begin(), bulges_.end());
}

std::uint32_t EdgeDrawing::new_node(Point position) {
  nodes_.push_back(position);
  return first_node_ + static_cast<std::uint32_t>(nodes_.size() - 1);
}

}  // namespace thiessen
