#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rainfall/network/network.h"
#include "rainfall/network/network_dual.h"

namespace thiessen {

/// Which gauges each gauge is compared with: those whose cells border on its own (its Delaunay
/// neighbours), and others at its place. Of a place with more than four gauges the first four stand
/// for all, so that no gauge has neighbours without number.
class GaugeNeighbours {
 public:
  /// A neighbour of a gauge, and which of all pairs of neighbours the two are.
  struct Neighbour {
    StationIndex station;
    std::uint32_t pair;
    bool is_second;  ///< whether the gauge is the pair's second
  };
  /// Two gauges that are neighbours, at least in the eyes of one of them.
  struct Pair {
    StationIndex first;
    StationIndex second;
  };

  /// `borders` are those of the network's dual, in which the first station of a place stands for
  /// it.
  GaugeNeighbours(const Network& network, std::span<const StationBorder> borders);

  std::size_t gauges() const { return begins_.size() - 1; }
  std::span<const Neighbour> of(StationIndex gauge) const {
    const std::size_t g = index(gauge);
    return {neighbours_.data() + begins_[g], begins_[g + 1] - begins_[g]};
  }
  std::span<const Pair> pairs() const { return pairs_; }

 private:
  std::vector<std::size_t> begins_;  ///< by gauge: where its neighbours begin, and the end
  std::vector<Neighbour> neighbours_;
  std::vector<Pair> pairs_;
};

}  // namespace thiessen
