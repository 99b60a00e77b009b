#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "earth/nearest/place_tree.h"

namespace thiessen {

/// A place and the square of its distance from where a search begins.
struct NearPlace {
  PlaceIndex place;
  double square;
};

/// Finds up to `count` of the wanted places of a tree, the nearest to `at` first, and puts them in
/// `near`. Of equally near places the one for which `goes_before(place, other)` is true comes
/// first. `farthest` is the square of a distance within which as many wanted places are known to
/// lie, or infinite: the less it is, the shorter is the search. Cost: log n and the count, where
/// places lie scattered and most of them are wanted; n at worst.
template <typename IsWanted, typename GoesBefore>
void find_near_places(const PlaceTree& tree, Direction at, std::size_t count, double farthest,
                      const IsWanted& is_wanted, const GoesBefore& goes_before,
                      std::vector<NearPlace>& near) {
  near.clear();
  if (count == 0) return;
  const auto before = [&](const NearPlace& a, const NearPlace& b) {
    return a.square != b.square ? a.square < b.square : goes_before(a.place, b.place);
  };
  // The margin keeps a place from being lost to the rounding of its ball's radius.
  constexpr double rounding = 1e-14;
  tree.search(
      [&](const Ball& ball) {
        const double distance = length(ball.centre - at);
        const double gap = distance - ball.radius - rounding * (distance + ball.radius);
        return gap > 0 && gap * gap > farthest;
      },
      [&](PlaceIndex p) {
        const Direction way = tree[p] - at;
        const double square = dot(way, way);
        if (square > farthest || !is_wanted(p)) return;
        near.push_back({p, square});
        std::push_heap(near.begin(), near.end(), before);
        if (near.size() > count) {
          std::pop_heap(near.begin(), near.end(), before);
          near.pop_back();
        }
        if (near.size() == count) farthest = std::min(farthest, near.front().square);
      });
  std::sort_heap(near.begin(), near.end(), before);
}

}  // namespace thiessen
