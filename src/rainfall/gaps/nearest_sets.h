#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "basin/nearest_ground.h"
#include "diagram/nearness.h"
#include "earth/cells/chart_nearness.h"
#include "rainfall/gaps/handover.h"
#include "rainfall/gaps/remembered.h"

namespace thiessen {

/// What ground some cells are the nearest to, and which cell is the next there.
///
/// The ground whose nearest n gauges are a given set, in any order, is that set's Thiessen polygon
/// of order n (M. I. Shamos and D. Hoey, Closest-point problems, 1975). If all of the set but one
/// are silent that one has this ground, and if it falls silent, too, the next has it, or where that
/// is silent the set with it is looked at. So whatever is silent, what a gauge's silence changes is
/// a sum over such sets. There are few of them, about 2n - 1 a gauge, and each depends on the
/// gauges near it alone; so they come again where neither components nor neighbourhoods do.
///
/// The next cell is always one next to the set in the full network: on the straight way to it a
/// point is among cells of the set all along.
class NearestSets {
 public:
  /// A set's ground by basin, then by the cell that is next.
  struct Shares {
    /// Whether it is told; not on the Earth where a cell's ground is wider than a chart that tells
    /// how near gauges are.
    bool is_known = true;
    std::vector<CellWeight> weights;  ///< in the basin
  };
  /// What one thread works with; its memory is used again.
  struct Bench {
    NearestGround ground;
    std::vector<PlaceIndex> places;
    std::vector<Nearness> nearness;
  };

  /// The handovers must outlive this object. `bytes` bounds what is remembered.
  NearestSets(const Handovers& handovers, std::size_t bytes);
  ~NearestSets();

  Bench bench() const;
  /// The shares of a set of cells, which depend on it alone. Requires `cells` in rising order.
  /// Normals play no part. Safe for several threads at once, each with its own bench. Cost: some
  /// microseconds for a small set that is not remembered.
  std::shared_ptr<const Shares> of(std::span<const PlaceIndex> cells, Bench& bench);

 private:
  struct ChartedCell;
  struct Slot {
    std::mutex mutex;
    std::unique_ptr<ChartedCell> charted;
  };

  Shares computed(std::span<const PlaceIndex> cells, Bench& bench);
  void find_places(std::span<const PlaceIndex> cells, Bench& bench) const;
  void add_in_plane(std::size_t members, std::size_t own, Bench& bench, Shares& shares) const;
  void add_on_earth(std::size_t members, std::size_t own, Bench& bench, Shares& shares);
  void add(const Handovers::Region& region, double scale, std::size_t members, std::size_t own,
           Bench& bench, Shares& shares) const;
  double least_area(const Handovers::Region& region) const;
  std::unique_ptr<ChartedCell> charted(PlaceIndex cell) const;
  bool find_nearness(ChartedCell& cell, Bench& bench);
  bool takes(std::size_t bytes);

  const Handovers& handovers_;
  Remembered<PlaceIndex, Shares> remembered_;
  std::vector<EarthPoint> places_;  // on the Earth
  std::vector<Slot> slots_;         // by cell, on the Earth
  std::atomic<std::size_t> bytes_left_;
};

}  // namespace thiessen
