#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "earth/conformal_sphere.h"
#include "earth/yardstick.h"

namespace thiessen {

inline double square_distance(Direction a, Direction b) {
  return dot(a - b, a - b);
}

/// Places in space, numbered from 0 in an order that their positions alone decide: along Hilbert's
/// curve, so that those of near numbers are mostly near.
class Sites {
 public:
  /// Requires fewer than 2^32 places, different ones. Cost: n log n.
  Sites(std::span<const Point> places, Metric metric);

  std::size_t size() const { return at_.size(); }
  Direction operator[](std::uint32_t site) const { return at_[site]; }
  std::span<const Direction> all() const { return at_; }
  /// The site of a place, and the place of a site.
  std::uint32_t of_place(std::size_t place) const { return site_of_[place]; }
  std::uint32_t place_of(std::uint32_t site) const { return place_of_[site]; }

  /// Up to `count` other sites for each, the nearest first, those equally near by their numbers.
  /// Cost: log n each where places lie scattered; at worst n.
  std::vector<std::vector<std::uint32_t>> nearest_others(std::size_t count) const;

 private:
  std::vector<Direction> at_;
  std::vector<std::uint32_t> site_of_;
  std::vector<std::uint32_t> place_of_;
};

}  // namespace thiessen
