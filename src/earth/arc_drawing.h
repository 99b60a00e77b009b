#pragma once

#include <cstdint>

#include "earth/bisector_arc.h"
#include "tessellation/diagram.h"

namespace thiessen {

inline constexpr std::uint32_t no_node = 0xFFFFFFFFu;

/// A point of an arc: the angle along it, and its node in the diagram (no_node until a chord needs
/// one).
struct ArcPoint {
  double angle;
  std::uint32_t node;
  Point position;
};

/// Draws arcs of great circles of the conformal sphere into a diagram, as chords that are straight
/// in longitude and latitude and within a tolerance in metres of the arc; what is far from the
/// diagram's frame is left out. Longitudes run from half a turn west of the frame's centre to half
/// a turn east; a chord over that meridian is drawn on both sides.
class ArcDrawing {
 public:
  /// The diagram must outlive it and have its frame.
  ArcDrawing(Diagram& diagram, double tolerance);

  Point position_of(Direction p) const;
  std::uint32_t new_node(Point position);
  /// Requires from.angle <= to.angle. Cost: in proportion to the chords.
  void draw(const BisectorArc& arc, ArcPoint from, ArcPoint to, PlaceIndex left, PlaceIndex right);

 private:
  ArcPoint point_at(const BisectorArc& arc, double angle) const;
  void draw_piece(const BisectorArc& arc, ArcPoint& start, ArcPoint& end);
  bool comes_near_frame(Point centre, double half_angle) const;
  void draw_chord(ArcPoint& start, ArcPoint& end);
  std::uint32_t turned(Point position, double degrees);

  Diagram& diagram_;
  double tolerance_;
  double west_;
  PlaceIndex left_{};
  PlaceIndex right_{};
};

}  // namespace thiessen
