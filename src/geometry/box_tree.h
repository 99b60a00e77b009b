#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box.h"

namespace thiessen {

/// Finds the boxes that meet a given one. It is a static tree, packed along Hilbert's curve (Kamel
/// and Faloutsos, On packing R-trees, 1993). Cost: n log n to build; a search takes log n and what
/// it finds, for boxes that overlap little. Memory: 36 bytes a box.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box> boxes);

  /// Calls `found(position)` for every box that meets `sought`, where `position` is the box's index
  /// in the list that the tree was built from. The order is the tree's own.
  template <typename Found>
  void search(const Box& sought, Found&& found) const {
    if (levels_.empty()) return;
    search_node(sought, levels_.size() - 1, 0, found);
  }

 private:
  static constexpr std::size_t fan = 8;

  void put_in_order(std::span<const Box> boxes, const Box& all);

  template <typename Found>
  void search_node(const Box& sought, std::size_t level, std::size_t first, Found& found) const {
    const std::vector<Box>& boxes = levels_[level];
    const std::size_t end = std::min(first + fan, boxes.size());
    for (std::size_t i = first; i < end; ++i) {
      if (!boxes[i].meets(sought)) continue;
      if (level == 0) {
        found(positions_[i]);
      } else {
        search_node(sought, level - 1, i * fan, found);
      }
    }
  }

  std::vector<std::uint32_t> positions_;
  std::vector<std::vector<Box>> levels_;  // the boxes themselves, then ever larger groups of `fan`
};

}  // namespace thiessen
