#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/gaps/handover.h"
#include "rainfall/gaps/remembered.h"

namespace thiessen {

/// What a reporting cell beside silent ones hands over when it falls silent, too.
///
/// Its ground, of its own and of what silent cells handed to it, goes to the cells that border it
/// among those that report, for it is convex and they are nearest beyond its sides. These are its
/// neighbours in the full network that report, and the heirs that border it in the ground of the
/// components beside it. So only the parts that it has taken over are shared anew, among few cells,
/// however large the components are; and the result is remembered by those cells and parts, which
/// come again where components do not. Where all cells are those of the joint component of it and
/// those beside it, this is its handover less theirs (tests/rainfall/gaps/departures_test.cpp).
/// Normals play no part.
class Departures {
 public:
  /// The silent cells beside a cell at some step.
  struct Beside {
    std::span<const std::shared_ptr<const Handover>> components;  ///< each with made_of
    std::span<const PlaceIndex> reporting;  ///< the cell's neighbours that report
  };
  /// What one thread works with; its memory is used again.
  struct Bench {
    std::vector<PlaceIndex> heirs;
    std::vector<std::uint32_t> regions;
    std::vector<std::uint32_t> key;
  };

  /// The handovers must outlive this object. `bytes` bounds what is remembered.
  Departures(const Handovers& handovers, std::size_t bytes)
      : handovers_(handovers), remembered_(bytes) {}

  /// Calls visit(basin, heir, weight) for the changes of weights by the cell's silence. They come
  /// in any order, and in several parts, some below 0; those of the cell itself are left out.
  /// Changes of other basins than those in which the cell weighs may come, too; they add up to 0.
  /// Safe for several threads, each with its own bench.
  template <typename Visit>
  void of(PlaceIndex cell, const Beside& beside, Bench& bench, const Visit& visit) {
    bench.heirs.assign(beside.reporting.begin(), beside.reporting.end());
    bench.regions = handovers_.regions_of(cell);
    for (const auto& component : beside.components) {
      add_borders(cell, component->made_of, bench.heirs);
      for_each_taken_region(cell, component->made_of, [&](std::span<const HandedPart> shares) {
        bench.regions.push_back(shares.front().region);
        for (const HandedPart& part : shares) {
          if (part.heir == cell) continue;
          bench.heirs.push_back(part.heir);
          visit(handovers_.full()[part.region].basin, part.heir, -part.weight);
        }
      });
    }
    const auto shares = shared(bench);
    for (const CellWeight& share : *shares) visit(share.basin, share.cell, share.weight);
  }

 private:
  using Shares = std::vector<CellWeight>;

  /// Calls visit(parts) for each region of which the cell has taken over a part.
  template <typename Visit>
  static void for_each_taken_region(PlaceIndex cell, const HandoverParts& made_of,
                                    const Visit& visit) {
    const std::span<const HandedPart> parts(made_of.parts);
    for (std::size_t first = 0; first < parts.size();) {
      std::size_t end = first;
      bool is_taken = false;
      for (; end < parts.size() && parts[end].region == parts[first].region; ++end)
        is_taken = is_taken || parts[end].heir == cell;
      if (is_taken) visit(parts.subspan(first, end - first));
      first = end;
    }
  }
  static void add_borders(PlaceIndex cell, const HandoverParts& made_of,
                          std::vector<PlaceIndex>& heirs);
  std::shared_ptr<const Shares> shared(Bench& bench);

  const Handovers& handovers_;
  Remembered<std::uint32_t, Shares> remembered_;
};

}  // namespace thiessen
