#pragma once

#include <cstdint>
#include <vector>

#include "diagram/diagram.h"
#include "geometry/box.h"
#include "geometry/box_tree.h"

namespace thiessen {

/// The box of a chord.
inline Box box_of(const Diagram& diagram, const Chord& chord) {
  return box_of(diagram.nodes[chord.from], diagram.nodes[chord.to]);
}

/// Finds the chords of a diagram whose boxes meet a given one. The diagram must outlive it. Cost:
/// building n log n; a search log n and what it finds. Memory: 20 bytes a chord. A few chords, as
/// those of the cells next to a silent one, are looked through instead, which is faster.
class ChordIndex {
 public:
  explicit ChordIndex(const Diagram& diagram);

  /// Calls `found(chord)`, the chord's position in the diagram.
  template <typename Found>
  void for_each_near(const Box& box, Found&& found) const {
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
  std::vector<std::uint32_t> first_of_run_;  // chords, a few that follow each other at a time
  BoxTree tree_;                             // of the runs
  std::vector<Box> boxes_;                   // of chords where they are few, in place of the tree
};

}  // namespace thiessen
