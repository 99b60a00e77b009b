#pragma once

#include "diagram/diagram.h"

namespace thiessen {

/// The turn of longitudes in which a diagram is drawn: from 180 degrees west of the frame's centre
/// to 180 degrees east of it. Its western and its eastern side are one meridian, the seam.
class LongitudeTurn {
 public:
  explicit LongitudeTurn(const Box& frame);

  double west() const { return west_; }
  /// The point with its longitude in [west, west + 360). A point within a micrometre of the seam or
  /// of the antimeridian, where maps are cut, is put on it: rounding would leave an edge that runs
  /// along them now on the one side and now on the other.
  Point within(Point p) const;
  /// Whether a longitude is more than a degree from the seam and the antimeridian, within the turn.
  bool is_clear_of_cuts(double x) const;
  /// Draws the chords over the seam, or along it, on both sides of the map; before, each is there
  /// once. Chords that meet do so on either side. Requires nodes within the turn. Cost: n log n in
  /// the chords at the seam.
  void draw_on_both_sides(Diagram& diagram) const;

 private:
  double west_;
  double antimeridian_;  // the one within the turn
};

}  // namespace thiessen
