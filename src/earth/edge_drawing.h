#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "diagram/diagram.h"
#include "earth/bisector_offset.h"
#include "earth/geodesic_bisector.h"

namespace thiessen {

/// A point of an edge: the angle along its great circle, and its node in the diagram (no_node until
/// a chord needs one).
struct EdgePoint {
  double angle;
  std::uint32_t node;
  Point position;
};

/// The longitudes in which a diagram is drawn: from half a turn west of the frame's centre to half
/// a turn east.
class LongitudeTurn {
 public:
  explicit LongitudeTurn(const Box& frame) : west_(frame.centre().x - 180) {}
  double west() const { return west_; }
  Point within(Point p) const {
    p.x -= 360 * std::floor((p.x - west_) / 360);
    return p;
  }

 private:
  double west_;
};

/// Draws edges between cells, as chords that are straight in longitude and latitude and within a
/// tolerance in metres of the edge; what is far from the frame is left out. A chord over the
/// meridian opposite the frame is drawn on both sides.
class EdgeDrawing {
 public:
  /// New nodes get numbers from `first_node` on.
  EdgeDrawing(const Box& frame, double tolerance, std::uint32_t first_node);

  /// Requires from.angle <= to.angle. Cost: in proportion to the chords.
  void draw(const GeodesicBisector& edge, EdgePoint from, EdgePoint to, PlaceIndex left,
            PlaceIndex right);

  /// Puts what was drawn behind what the diagram has: the nodes before `first_node` are its own.
  void add_to(Diagram& diagram) const;

 private:
  bool may_come_near(const GeodesicBisector& edge, double from, double to) const;
  std::pair<double, double> stretch_near(const GeodesicBisector& edge, double from,
                                         double to) const;
  EdgePoint point_at(const GeodesicBisector& edge, double angle) const;
  EdgePoint point_at(const BisectorOffset& offset, double angle) const;
  void draw_piece(const GeodesicBisector& edge, EdgePoint& start, EdgePoint& end);
  void draw_piece(const BisectorOffset& offset, EdgePoint& start, EdgePoint& end);
  void draw_chords(const BisectorOffset& offset, EdgePoint& start, EdgePoint& end, int chords);
  void draw_chord(EdgePoint& start, EdgePoint& end);
  std::uint32_t new_node(Point position);
  std::uint32_t turned(Point position, double degrees);

  Box frame_;
  double frame_size_;
  LongitudeTurn longitudes_;
  double tolerance_;
  std::uint32_t first_node_;
  PlaceIndex left_{};
  PlaceIndex right_{};
  std::vector<Point> nodes_;
  std::vector<Chord> chords_;
};

/// Whether the disc round `centre`, `radius` degrees wide on the sphere, meets the frame, or may.
bool may_come_near(const Box& frame, Point centre, double radius);

}  // namespace thiessen
