#pragma once

#include <cstdint>
#include <vector>

#include "diagram/diagram.h"
#include "geometry/box.h"
#include "geometry/box_tree.h"

namespace thiessen {

/// The bounding box of a chord.
inline Box box_of(const Diagram& diagram, const Chord& chord) {
  return box_of(diagram.nodes[chord.from], diagram.nodes[chord.to]);
}

/// How often chords are searched: so seldom that looking at all of them each time takes less than
/// putting them in order, or more often.
enum class Searches { few, many };

/// Finds the chords of a diagram whose boxes meet a given one. The diagram must outlive it. Cost: n
/// log n to build; for a search log n and the number of chords found. Memory: 20 bytes a chord.
/// Where searches are few there is nothing to build, and a search looks at all chords. A few
/// chords, such as those of the cells next to a silent gauge, are searched one by one, too, which
/// is faster.
class ChordIndex {
 public:
  explicit ChordIndex(const Diagram& diagram, Searches searches = Searches::many);

  /// Calls `found(chord)` for every chord whose box meets `box`; `chord` is its position in the
  /// diagram.
  template <typename Found>
  void for_each_near(const Box& box, Found&& found) const {
    if (searches_ == Searches::few) {
      for (std::uint32_t i = 0; i < diagram_.chords.size(); ++i) {
        if (box_of(diagram_, diagram_.chords[i]).meets(box)) found(i);
      }
      return;
    }
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
      if (boxes_[i].meets(box)) found(i);
    }
    tree_.search(box, [&](std::uint32_t run) {
      for (std::uint32_t i = first_of_run_[run]; i < first_of_run_[run + 1]; ++i) {
        if (box_of(diagram_, diagram_.chords[i]).meets(box)) found(i);
      }
    });
  }

 private:
  const Diagram& diagram_;
  Searches searches_;
  std::vector<std::uint32_t> first_of_run_;  // a run is a few chords that follow each other
  BoxTree tree_;                             // of the runs
  std::vector<Box> boxes_;  // of the chords, in place of the tree where they are few
};

}  // namespace thiessen
