#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "basin/basin.h"
#include "basin/sphere_shape.h"
#include "rainfall/gaps/cell_account.h"
#include "rainfall/gaps/cell_adjacency.h"
#include "rainfall/network_cells.h"
#include "rainfall/weights.h"

namespace thiessen {

/// What cells next to a component of silent ones take over, by basin, then by cell.
using Handover = std::vector<CellWeight>;

/// Who gets the ground of silent gauges.
///
/// When cells fall silent, each of their connected components leaves its ground to the reporting
/// cells next to it and to no others, whatever else is silent: going straight from a point to its
/// new owner one is in silent cells all the way, and so in one component. Hence the weights of
/// those that report are the full network's, and one handover more for each component.
class Handovers {
 public:
  /// Tessellates the full network and clips its cells to the basins. The weighing must outlive it.
  /// Memory: the cells' vertices within the basins.
  Handovers(const Weighing& weighing, unsigned threads);

  const NetworkCells& cells() const { return cells_; }
  const CellAdjacency& adjacency() const { return adjacency_; }
  /// The full network's weights, by basin, then by cell.
  const std::vector<CellWeight>& full() const { return full_; }
  /// Whether a cell has a part in any basin, in the full network.
  bool has_ground(PlaceIndex cell) const { return !regions_[index(cell)].empty(); }
  /// The weights by station: what Weighing::weights gives where all report.
  std::vector<BasinWeights> full_weights() const;

  /// The component's handover: a function of its cells alone. Empty where no cell is next to it.
  /// `component`: in rising order. The weights of a basin add up to those that its cells have in
  /// the full network, to 1e-13. Safe for several threads at once. Cost: the tessellation of the
  /// cells next to it, and the vertices of its own.
  Handover of(std::span<const PlaceIndex> component) const;

 private:
  /// A cell's ground in a basin.
  struct Region {
    std::uint32_t basin;
    Basin ground;
    double area;
    std::optional<SphereShape> shape;  // on the Earth, the same for charts
  };
  /// What a component's regions leave to each of its heirs, region by region.
  using Take = std::function<void(const Region&, const std::vector<CellShare>&)>;

  template <typename Visit>
  void for_each_region(std::span<const PlaceIndex> component, Visit&& visit) const {
    for (const PlaceIndex cell : component) {
      for (const Region& region : regions_[index(cell)]) visit(region);
    }
  }
  std::vector<PlaceIndex> heirs_of(std::span<const PlaceIndex> component) const;
  void add_regions(std::vector<std::vector<ClippedCell>> clipped);
  bool share_in_chart(std::span<const PlaceIndex> component, std::span<const Point> heirs,
                      const Take& take) const;
  void share(std::span<const PlaceIndex> component, std::span<const Point> heirs,
             const Take& take) const;

  const Weighing& weighing_;
  NetworkCells cells_;
  CellAdjacency adjacency_;
  std::vector<CellWeight> full_;
  std::vector<std::vector<Region>> regions_;  // by cell, in the order of the basins
};

}  // namespace thiessen
