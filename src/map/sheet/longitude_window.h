#pragma once

#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// A stretch of longitudes in degrees, eastward from `west`: the shortest one that holds all
/// longitudes of a study.
struct LongitudeWindow {
  double west = -180;
  double span = 360;

  double east() const { return west + span; }
  double middle() const { return west + span / 2; }
  /// The longitude brought into [west, west + 360) by whole turns.
  double place(double longitude) const;
};

/// Gathers the longitudes that rings and points take up, and finds the window that leaves out the
/// widest gap between them. Cost: the vertices, and memory that does not grow.
class LongitudeCensus {
 public:
  /// Adds the longitudes of a ring's edges. Edges take the short way round; one along a pole goes
  /// as its coordinates say.
  void add(const Ring& ring);
  void add(double longitude);
  /// The window of all that was added; the whole turn from -180 where no gap is left.
  LongitudeWindow window() const;

 private:
  void add_stretch(double from, double to);

  struct Slot {
    double low = 360;  ///< least and largest longitude seen in the slot, counted eastward from -180
    double high = -1;
    int begins = 0;  ///< stretches that begin in this slot, less those that end in the slot before
    bool seen() const { return high >= 0; }
  };
  std::vector<Slot> slots_ = std::vector<Slot>(slot_count);
  int always_ = 0;  ///< stretches that are already under way at the first slot

  static constexpr std::size_t slot_count = 3600;
};

/// The ring with whole turns added to its longitudes so that no edge but one along a pole spans
/// more than half a turn. Its first point is placed in the window. A ring that winds round the
/// Earth is closed over the pole nearer to it.
Ring unwrapped(const Ring& ring, const LongitudeWindow& window);

}  // namespace thiessen
