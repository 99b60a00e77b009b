#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "diagram/diagram.h"

namespace thiessen {

/// Tells which cells of a diagram are next to each other. Memory: 8 bytes a pair.
class CellAdjacency {
 public:
  explicit CellAdjacency(const Diagram& diagram);

  std::size_t cells() const { return first_.size() - 1; }
  /// The cells next to a cell, in rising order; none for a place without a cell of its own.
  std::span<const PlaceIndex> neighbours(PlaceIndex cell) const {
    return std::span(neighbours_)
        .subspan(first_[index(cell)], first_[index(cell) + 1] - first_[index(cell)]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<PlaceIndex> neighbours_;
};

/// Splits cells into their connected components. The cells of a component are in rising order, and
/// the components in the order of their first cells. Requires `cells` in rising order. Cost: the
/// number of the cells' neighbours.
std::vector<std::vector<PlaceIndex>> components_of(std::span<const PlaceIndex> cells,
                                                   const CellAdjacency& adjacency);

}  // namespace thiessen
