#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "earth/yardstick.h"
#include "geometry/direction.h"

namespace thiessen {

inline double square_distance(Direction a, Direction b) {
  return dot(a - b, a - b);
}

/// The places of a network as points in space. They are numbered from 0 along Hilbert's curve: this
/// order depends on their positions alone, and places with near numbers are mostly near each other.
class Sites {
 public:
  /// Requires fewer than 2^32 places, all different. Cost: n log n.
  Sites(std::span<const Point> places, Metric metric);

  std::size_t size() const { return at_.size(); }
  Direction operator[](std::uint32_t site) const { return at_[site]; }
  std::span<const Direction> all() const { return at_; }
  /// The site of the place with this number.
  std::uint32_t of_place(std::size_t place) const { return site_of_[place]; }
  std::uint32_t place_of(std::uint32_t site) const { return place_of_[site]; }

  /// Up to `count` other sites for each site, the nearest first; equally near ones are in the order
  /// of their numbers. Cost: log n for each site where places lie scattered, n at worst.
  std::vector<std::vector<std::uint32_t>> nearest_others(std::size_t count) const;

 private:
  double square_within_reach(std::uint32_t site, std::size_t count) const;

  std::vector<Direction> at_;
  std::vector<std::uint32_t> site_of_;
  std::vector<std::uint32_t> place_of_;
};

}  // namespace thiessen
