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
#include "rainfall/network/network_cells.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// The weights that the cells next to a component of silent cells take over, by basin, then by
/// cell.
using Handover = std::vector<CellWeight>;

/// Tells which gauges get the ground of silent ones.
///
/// When cells fall silent, each of their connected components leaves its ground to the reporting
/// cells next to it and to no others, whatever else is silent. The reason: the straight way from a
/// point to its new owner runs through silent cells until it reaches the owner's cell, and so
/// through one component. Hence the weights of the gauges that report are the full network's
/// weights plus one handover for each component.
class Handovers {
 public:
  /// Tessellates the full network and clips its cells to the basins. The weighing must outlive this
  /// object. Memory: the vertices of the cells within the basins.
  Handovers(const Weighing& weighing, unsigned threads);

  const NetworkCells& cells() const { return cells_; }
  const CellAdjacency& adjacency() const { return adjacency_; }
  /// The full network's weights, by basin, then by cell.
  const std::vector<CellWeight>& full() const { return full_; }
  /// Whether a cell of the full network has a part in any basin.
  bool has_ground(PlaceIndex cell) const { return !regions_[index(cell)].empty(); }
  /// The full network's weights by station, as Weighing::weights gives them when all report.
  std::vector<BasinWeights> full_weights() const;

  /// The handover of a component, which depends on its cells alone; empty where no cell is next to
  /// it. Requires `component` in rising order. In each basin the weights add up to what the
  /// component's cells have in the full network, to 1e-13. Safe for several threads at once. Cost:
  /// the tessellation of the cells next to the component, and the vertices of its own.
  Handover of(std::span<const PlaceIndex> component) const;

 private:
  /// The part of a cell that lies in a basin.
  struct Region {
    std::uint32_t basin;
    Basin ground;
    double area;
    std::optional<SphereShape> shape;  // the ground once more, for charts; only on the Earth
  };
  /// Takes the shares of a component's heirs in one of its regions; it is called region by region.
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
