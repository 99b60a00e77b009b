#include "earth/arc_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// How far, in metres, an arc's middle lies from its chord's.
double bulge(Point start, Point middle, Point end) {
  const double north = (start.y + end.y) / 2 - middle.y;
  const double to_start = short_way(start.x - middle.x);
  const double to_end = short_way(end.x - middle.x);
  const double east = (to_start + to_end) / 2 * std::cos(middle.y * degree);
  return std::sqrt(north * north + east * east) * degree * mean_radius;
}

}  // namespace

ArcDrawing::ArcDrawing(Diagram& diagram, double tolerance)
    : diagram_(diagram), tolerance_(tolerance), west_(diagram.frame.centre().x - 180) {}

Point ArcDrawing::position_of(Direction p) const {
  Point position = from_sphere(p);
  position.x -= 360 * std::floor((position.x - west_) / 360);
  return position;
}

std::uint32_t ArcDrawing::new_node(Point position) {
  diagram_.nodes.push_back(position);
  return static_cast<std::uint32_t>(diagram_.nodes.size() - 1);
}

void ArcDrawing::draw(const BisectorArc& arc, ArcPoint from, ArcPoint to, PlaceIndex left,
                      PlaceIndex right) {
  left_ = left;
  right_ = right;
  const int pieces =
      std::max(1, static_cast<int>(std::ceil((to.angle - from.angle) / longest_piece)));
  ArcPoint start = from;
  for (int i = 1; i <= pieces; ++i) {
    ArcPoint end =
        i == pieces ? to : point_at(arc, from.angle + (to.angle - from.angle) * i / pieces);
    draw_piece(arc, start, end);
    start = end;
  }
}

ArcPoint ArcDrawing::point_at(const BisectorArc& arc, double angle) const {
  return {angle, no_node, position_of(arc.at(angle))};
}

// Halves the piece until its chord is near enough to it, or all of it is far from the frame.
void ArcDrawing::draw_piece(const BisectorArc& arc, ArcPoint& start, ArcPoint& end) {
  const double half = (end.angle - start.angle) / 2;
  ArcPoint middle = point_at(arc, start.angle + half);
  if (!comes_near_frame(middle.position, half)) return;
  const bool fine = 2 * half <= longest_chord &&
                    bulge(start.position, middle.position, end.position) <= tolerance_;
  if (fine || half < shortest_chord) {
    draw_chord(start, end);
    return;
  }
  draw_piece(arc, start, middle);
  draw_piece(arc, middle, end);
}

// Whether the disc round `centre` that holds the piece meets the frame, or may.
bool ArcDrawing::comes_near_frame(Point centre, double half_angle) const {
  const double reach = half_angle / degree + 1e-3;
  const double stretch = 1 + 0.01;  // of latitudes from the sphere to the ellipsoid
  const double south = centre.y - stretch * reach - 0.2 * std::min(1.0, reach);
  const double north = centre.y + stretch * reach + 0.2 * std::min(1.0, reach);
  const Box& frame = diagram_.frame;
  if (south > frame.high.y || north < frame.low.y) return false;
  if (north >= 89.5 || south <= -89.5) return true;
  const double widest = std::max(std::abs(south), std::abs(north)) * degree;
  const double east_west = reach / std::cos(widest);
  const double distance = std::abs(short_way(centre.x - frame.centre().x));
  return distance <= east_west + frame.width() / 2;
}

void ArcDrawing::draw_chord(ArcPoint& start, ArcPoint& end) {
  if (start.node == no_node) start.node = new_node(start.position);
  if (end.node == no_node) end.node = new_node(end.position);
  const double step = end.position.x - start.position.x;
  if (std::abs(step) <= 180) {
    if (start.node == end.node) return;
    diagram_.chords.push_back({start.node, end.node, left_, right_});
    if (start.position.x == west_ || end.position.x == west_) {
      diagram_.chords.push_back(
          {turned(start.position, 360), turned(end.position, 360), left_, right_});
    }
    return;
  }
  // Over the meridian opposite the frame's: once beyond its eastern side and once beyond its
  // western.
  const double turn = step > 0 ? -360 : 360;
  diagram_.chords.push_back({start.node, turned(end.position, turn), left_, right_});
  diagram_.chords.push_back({turned(start.position, -turn), end.node, left_, right_});
}

std::uint32_t ArcDrawing::turned(Point position, double degrees) {
  return new_node({position.x + degrees, position.y});
}

}  // namespace thiessen
