#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "diagram/diagram.h"
#include "earth/cells/bisector_offset.h"
#include "earth/cells/geodesic_bisector.h"
#include "earth/cells/longitude_turn.h"
#include "earth/cells/short_edge.h"

namespace thiessen {

/// A point of an edge between two cells: its angle along the edge's great circle, and its node in
/// the diagram (no_node until a chord needs one).
struct EdgePoint {
  double angle;
  std::uint32_t node;
  Point position;
};

/// Draws edges between cells as chords that are straight in longitude and latitude and within a
/// tolerance in metres of the edge, each with the area between the edge and itself. Parts of edges
/// that are far from the frame are left out. A chord over the meridian opposite the frame is drawn
/// once, with its ends on either side of the map: see LongitudeTurn::draw_on_both_sides.
///
/// A pole is no point of the map but its whole border. So each edge that ends at a pole, or passes
/// it, ends there at a node of its own, at the longitude in which it arrives, and a chord leads on
/// from there beyond the map.
class EdgeDrawing {
 public:
  /// `tolerance` is in metres. New nodes get numbers from `first_node` on.
  EdgeDrawing(const Box& frame, double tolerance, std::uint32_t first_node);

  /// Draws the edge between the cells of `left` and `right`. Requires from.angle <= to.angle. The
  /// node of an end at a pole is not used. Cost: in proportion to the chords.
  void draw(const GeodesicBisector& edge, EdgePoint from, EdgePoint to, PlaceIndex left,
            PlaceIndex right);

  /// Whether an edge that may be short is drawn by draw_short: both its ends lie within the frame,
  /// and far from poles and from the sides of maps.
  bool may_be_short(Point from, Point to) const;
  /// Draws a short edge as draw would, to a micrometre. Returns false where it does not, since the
  /// edge is long against the frame or bends unevenly.
  bool draw_short(const ShortEdge& edge, EdgePoint from, EdgePoint to, PlaceIndex left,
                  PlaceIndex right);

  /// How many new nodes and chords there are.
  std::size_t nodes() const { return nodes_.size(); }
  std::size_t chords() const { return chords_.size(); }
  /// Appends the new nodes and chords to the diagram. Nodes numbered below `first_node` are the
  /// diagram's own.
  void add_to(Diagram& diagram) const;

 private:
  void draw_between_poles(const GeodesicBisector& edge, EdgePoint from, EdgePoint to);
  bool reaches(double pole) const;
  EdgePoint end_at_pole(const GeodesicBisector& edge, double angle, double inward, double pole);
  bool may_come_near(const GeodesicBisector& edge, double from, double to) const;
  std::pair<double, double> stretch_near(const GeodesicBisector& edge, double from,
                                         double to) const;
  EdgePoint point_at(const GeodesicBisector& edge, double angle) const;
  EdgePoint point_at(const BisectorOffset& offset, double angle) const;
  void draw_piece(const GeodesicBisector& edge, EdgePoint& start, EdgePoint& end);
  void draw_piece(const BisectorOffset& offset, EdgePoint& start, EdgePoint& end);
  void draw_chords(const BisectorOffset& offset, EdgePoint& start, EdgePoint& end, int chords);
  bool is_long(double half) const;
  void draw_chord(EdgePoint& start, EdgePoint& end, double bulge);
  void add_chord(std::uint32_t from, std::uint32_t to, double bulge);
  double bulge_of(const BisectorOffset& offset, const EdgePoint& start, const EdgePoint& end) const;
  std::uint32_t new_node(Point position);

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
