#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "diagram/diagram.h"
#include "earth/cells/bisector_offset.h"
#include "earth/cells/geodesic_bisector.h"

namespace thiessen {

/// A point of an edge between two cells: its angle along the edge's great circle, and its node in
/// the diagram (no_node until a chord needs one).
struct EdgePoint {
  double angle;
  std::uint32_t node;
  Point position;
};

/// The turn of longitudes in which a diagram is drawn: from 180 degrees west of the frame's centre
/// to 180 degrees east of it.
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

/// Draws edges between cells as chords that are straight in longitude and latitude and within a
/// tolerance in metres of the edge, each with the area between the edge and itself. Parts of edges
/// that are far from the frame are left out. A chord over the meridian opposite the frame is drawn
/// on both sides of the map.
class EdgeDrawing {
 public:
  /// `tolerance` is in metres. New nodes get numbers from `first_node` on.
  EdgeDrawing(const Box& frame, double tolerance, std::uint32_t first_node);

  /// Draws the edge between the cells of `left` and `right`. Requires from.angle <= to.angle. Cost:
  /// in proportion to the chords.
  void draw(const GeodesicBisector& edge, EdgePoint from, EdgePoint to, PlaceIndex left,
            PlaceIndex right);

  /// Appends the new nodes and chords to the diagram. Nodes numbered below `first_node` are the
  /// diagram's own.
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
  void draw_chord(EdgePoint& start, EdgePoint& end, double bulge);
  void add_chord(std::uint32_t from, std::uint32_t to, double bulge);
  double bulge_of(const BisectorOffset& offset, const EdgePoint& start, const EdgePoint& end) const;
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
  std::vector<double> bulges_;  // by chord
};

/// Whether the disc round `centre`, with a radius of `radius` degrees on the sphere, may meet the
/// frame. It may say yes where the disc only comes near.
bool may_come_near(const Box& frame, Point centre, double radius);

}  // namespace thiessen
