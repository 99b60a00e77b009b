#pragma once

#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// A stretch of longitudes, eastward from `west`, in degrees: the shortest that holds what was
/// looked at.
struct LongitudeWindow {
  double west = -180;
  double span = 360;

  double east() const { return west + span; }
  double middle() const { return west + span / 2; }
  /// The longitude, whole turns added, in [west, west + 360).
  double place(double longitude) const;
};

/// Gathers the longitudes that rings and points take up, and finds the window that leaves out the
/// widest gap between them. Cost: the vertices, and memory that does not grow.
class LongitudeCensus {
 public:
  /// Edges take the short way round; one along a pole goes as its coordinates say.
  void add(const Ring& ring);
  void add(double longitude);
  /// Of what was added; the whole turn, from -180, where no gap is left.
  LongitudeWindow window() const;

 private:
  void add_stretch(double from, double to);

  struct Slot {
    double low = 360;  ///< the least and largest longitude seen in the slot, from its own west
    double high = -1;
    int begins = 0;  ///< stretches that begin here, less those that end before the next slot
    bool seen() const { return high >= 0; }
  };
  std::vector<Slot> slots_ = std::vector<Slot>(slot_count);
  int always_ = 0;  ///< stretches that are under way at the first slot

  static constexpr std::size_t slot_count = 3600;
};

/// The ring with whole turns added so that no edge but one along a pole spans more than half a
/// turn, its first point placed in the window. A ring that winds round the Earth is closed over the
/// pole nearer to it.
Ring unwrapped(const Ring& ring, const LongitudeWindow& window);

}  // namespace thiessen
