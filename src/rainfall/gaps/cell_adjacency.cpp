#include "rainfall/gaps/cell_adjacency.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace thiessen {

CellAdjacency::CellAdjacency(const Diagram& diagram) {
  std::vector<std::pair<PlaceIndex, PlaceIndex>> pairs;
  pairs.reserve(2 * diagram.neighbours.size());
  for (const auto& [p, q] : diagram.neighbours) {
    const PlaceIndex a = diagram.cell_of[index(p)];
    const PlaceIndex b = diagram.cell_of[index(q)];
    if (a == b) continue;
    pairs.emplace_back(a, b);
    pairs.emplace_back(b, a);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  first_.assign(diagram.places.size() + 1, 0);
  neighbours_.reserve(pairs.size());
  for (const auto& [a, b] : pairs) {
    ++first_[index(a) + 1];
    neighbours_.push_back(b);
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

std::vector<std::vector<PlaceIndex>> components_of(std::span<const PlaceIndex> cells,
                                                   const CellAdjacency& adjacency) {
  std::vector<std::uint8_t> waits(adjacency.cells(), 0);
  for (const PlaceIndex cell : cells) waits[index(cell)] = 1;
  std::vector<std::vector<PlaceIndex>> components;
  for (const PlaceIndex cell : cells) {
    if (waits[index(cell)] == 0) continue;
    waits[index(cell)] = 0;
    std::vector<PlaceIndex>& component = components.emplace_back(1, cell);
    for (std::size_t next = 0; next < component.size(); ++next) {
      for (const PlaceIndex q : adjacency.neighbours(component[next])) {
        if (waits[index(q)] == 0) continue;
        waits[index(q)] = 0;
        component.push_back(q);
      }
    }
    std::sort(component.begin(), component.end());
  }
  return components;
}

}  // namespace thiessen
