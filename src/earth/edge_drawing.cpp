#include "earth/edge_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "earth/conformal_sphere.h"

namespace thiessen {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double mean_radius = 6371008.8;  // metres
// In radians.
constexpr double longest_piece = std::numbers::pi / 8;
constexpr double longest_chord = 0.02;
constexpr double shortest_chord = 1e-10;

/// A difference of longitudes less than a turn and a half, the short way round.
double short_way(double difference) {
  if (difference > 180) return difference - 360;
  if (difference < -180) return difference + 360;
  return difference;
}

/// How far, in metres, an edge's middle lies from its chord's.
double bulge(Point start, Point middle, Point end) {
  const double north = (start.y + end.y) / 2 - middle.y;
  const double to_start = short_way(start.x - middle.x);
  const double to_end = short_way(end.x - middle.x);
  const double east = (to_start + to_end) / 2 * std::cos(middle.y * degree);
  return std::sqrt(north * north + east * east) * degree * mean_radius;
}

/// Whether the disc round `centre`, `radius` degrees wide on the sphere, meets the frame, or may.
bool meets(const Box& frame, Point centre, double radius) {
  const double stretch = 1.01;  // of latitudes from the sphere to the ellipsoid
  const double south = centre.y - stretch * radius;
  const double north = centre.y + stretch * radius;
  if (south > frame.high.y || north < frame.low.y) return false;
  if (north >= 89.5 || south <= -89.5) return true;
  const double widest = std::max(std::abs(south), std::abs(north)) * degree;
  const double east_west = stretch * radius / std::cos(widest);
  const double distance = std::abs(short_way(std::remainder(centre.x - frame.centre().x, 360)));
  return distance <= east_west + frame.width() / 2;
}

}  // namespace

bool may_come_near(const Box& frame, const GeodesicBisector& edge, double from, double to) {
  const double half = (to - from) / 2;
  const double middle = from + half;
  const double radius = half / degree + edge.farthest_off();
  if (!meets(frame, from_sphere(edge.arc().at(middle)), radius)) return false;
  if (half <= edge.farthest_off() * degree / 4) return true;
  return may_come_near(frame, edge, from, middle) || may_come_near(frame, edge, middle, to);
}

EdgeDrawing::EdgeDrawing(const Box& frame, double tolerance, std::uint32_t first_node)
    : frame_(frame), longitudes_(frame), tolerance_(tolerance), first_node_(first_node) {}

void EdgeDrawing::draw(const GeodesicBisector& edge, EdgePoint from, EdgePoint to, PlaceIndex left,
                       PlaceIndex right) {
  left_ = left;
  right_ = right;
  const int pieces =
      std::max(1, static_cast<int>(std::ceil((to.angle - from.angle) / longest_piece)));
  EdgePoint start = from;
  for (int i = 1; i <= pieces; ++i) {
    const double angle = from.angle + (to.angle - from.angle) * i / pieces;
    EdgePoint end = i == pieces ? to : point_at(edge, angle);
    draw_piece(edge, start, end);
    start = end;
  }
}

EdgePoint EdgeDrawing::point_at(const GeodesicBisector& edge, double angle) const {
  return {angle, no_node, longitudes_.within(edge.at(angle))};
}

// Halves the piece until its chord is near enough to it, or all of it is far from the frame.
void EdgeDrawing::draw_piece(const GeodesicBisector& edge, EdgePoint& start, EdgePoint& end) {
  const double half = (end.angle - start.angle) / 2;
  const double angle = start.angle + half;
  const double radius = half / degree + edge.farthest_off();
  if (!meets(frame_, from_sphere(edge.arc().at(angle)), radius)) return;
  EdgePoint middle = point_at(edge, angle);
  const bool fine = 2 * half <= longest_chord &&
                    bulge(start.position, middle.position, end.position) <= tolerance_;
  if (fine || half < shortest_chord) {
    draw_chord(start, end);
    return;
  }
  draw_piece(edge, start, middle);
  draw_piece(edge, middle, end);
}

void EdgeDrawing::draw_chord(EdgePoint& start, EdgePoint& end) {
  if (start.node == no_node) start.node = new_node(start.position);
  if (end.node == no_node) end.node = new_node(end.position);
  const double step = end.position.x - start.position.x;
  if (std::abs(step) <= 180) {
    if (start.node == end.node) return;
    chords_.push_back({start.node, end.node, left_, right_});
    if (start.position.x == longitudes_.west() || end.position.x == longitudes_.west()) {
      chords_.push_back({turned(start.position, 360), turned(end.position, 360), left_, right_});
    }
    return;
  }
  // Over the meridian opposite the frame's: once beyond its eastern side and once beyond its
  // western.
  const double turn = step > 0 ? -360 : 360;
  chords_.push_back({start.node, turned(end.position, turn), left_, right_});
  chords_.push_back({turned(start.position, -turn), end.node, left_, right_});
}

void EdgeDrawing::add_to(Diagram& diagram) const {
  const auto shift = static_cast<std::uint32_t>(diagram.nodes.size()) - first_node_;
  const auto shifted = [&](std::uint32_t node) { return node < first_node_ ? node : node + shift; };
  diagram.nodes.insert(diagram.nodes.end(), nodes_.begin(), nodes_.end());
  for (const Chord& chord : chords_) {
    diagram.chords.push_back({shifted(chord.from), shifted(chord.to), chord.left, chord.right});
  }
}

std::uint32_t EdgeDrawing::new_node(Point position) {
  nodes_.push_back(position);
  return first_node_ + static_cast<std::uint32_t>(nodes_.size() - 1);
}

std::uint32_t EdgeDrawing::turned(Point position, double degrees) {
  return new_node({position.x + degrees, position.y});
}

}  // namespace thiessen
