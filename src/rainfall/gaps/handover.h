#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "basin/basin.h"
#include "basin/sphere_shape.h"
#include "rainfall/gaps/cell_account.h"
#include "rainfall/gaps/cell_adjacency.h"
#include "rainfall/network/network_cells.h"
#include "rainfall/network/weights.h"
#include "rainfall/normals/mean_normals.h"

namespace thiessen {

/// What normals make of the weights of cells, where there are normals: for each weight in turn and
/// for each of months_of.
struct WeightedNormals {
  std::size_t months = 0;  ///< figures a weight; 0 without normals
  /// Weight x the mean normal over its ground, relative to that of the first station.
  std::vector<double> normals;
  /// The share of the ground that has normals; empty where all ground of all basins has.
  std::vector<double> covered;

  /// The weight of a reading that is relative to its gauge's normal. `month` is a place_of.
  double at(std::size_t weight, std::size_t month) const {
    return normals[weight * months + month];
  }
  double covered_at(std::size_t weight, std::size_t month) const {
    return covered.empty() ? 1 : covered[weight * months + month];
  }
};

/// The part of a silent cell in a basin that one of the reporting cells takes over.
struct HandedPart {
  std::uint32_t region;  ///< the silent cell's part in the basin: its number among Handovers::full
  PlaceIndex heir;
  double weight;  ///< in that basin
};

/// What a handover is made of.
struct HandoverParts {
  std::vector<HandedPart> parts;  ///< region by region
  /// The pairs of heirs whose cells border each other in the ground that is handed over, each pair
  /// once and in any order; there are also pairs that border each other nowhere.
  std::vector<std::pair<PlaceIndex, PlaceIndex>> borders;
  /// All heirs, where no ground is handed over that lies in a basin; then any two of them may
  /// border each other.
  std::vector<PlaceIndex> unmeasured;
};

/// The weights that the cells next to a component of silent cells take over, by basin, then by
/// cell.
struct Handover {
  std::vector<CellWeight> shares;
  WeightedNormals weighted;
  HandoverParts made_of;  ///< empty unless it is asked for

  bool empty() const { return shares.empty(); }
  std::size_t size() const { return shares.size(); }
  const CellWeight& operator[](std::size_t share) const { return shares[share]; }
  auto begin() const { return shares.begin(); }
  auto end() const { return shares.end(); }
  /// What a share weighs in a month: its weight without normals.
  double bearing(std::size_t share, std::size_t month) const {
    return weighted.months == 0 ? shares[share].weight : weighted.at(share, month);
  }
};

/// Tells which gauges get the ground of silent ones.
///
/// When cells fall silent, each of their connected components leaves its ground to the reporting
/// cells next to it and to no others, whatever else is silent. The reason: the straight way from a
/// point to its new owner runs through silent cells until it reaches the owner's cell, and so
/// through one component. Hence the weights of the gauges that report are the full network's
/// weights plus one handover for each component.
class Handovers {
 public:
  /// What normals' measures say of the edges of a region, once it is handed over.
  struct EdgeFigures {
    std::once_flag once;
    std::vector<double> figures;
  };
  /// The part of a cell that lies in a basin.
  struct Region {
    std::uint32_t basin;
    Basin ground;
    double area;
    std::optional<SphereShape> shape;  ///< the ground once more, for charts; only on the Earth
    std::size_t number;                ///< its place among full()
    std::unique_ptr<EdgeFigures> edges = std::make_unique<EdgeFigures>();
  };

  /// Tessellates the full network and clips its cells to the basins. The weighing must outlive this
  /// object. Memory: the vertices of the cells within the basins, and with normals their figures on
  /// each edge of the ground that is handed over.
  Handovers(const Weighing& weighing, unsigned threads);

  const NetworkCells& cells() const { return cells_; }
  const CellAdjacency& adjacency() const { return adjacency_; }
  /// The full network's weights, by basin, then by cell.
  const std::vector<CellWeight>& full() const { return full_; }
  /// What normals make of these.
  const WeightedNormals& full_normals() const { return full_normals_; }
  /// The normals; null without.
  const NormalField* normals() const { return weighing_.normals(); }
  /// Whether a cell of the full network has a part in any basin.
  bool has_ground(PlaceIndex cell) const { return !regions_[index(cell)].empty(); }
  /// The parts of a cell of the full network in the basins.
  std::span<const Region> ground_of(PlaceIndex cell) const { return regions_[index(cell)]; }
  const Weighing& weighing() const { return weighing_; }
  /// The full network's weights by station, as Weighing::weights gives them when all report, with
  /// the factors of a month or of the year.
  std::vector<BasinWeights> full_weights(const NormalMonth& month = {}) const;

  /// The handover of a component, which depends on its cells alone; empty where no cell is next to
  /// it. Requires `component` in rising order. In each basin the weights add up to what the
  /// component's cells have in the full network, to 1e-13. Safe for several threads at once. Cost:
  /// the tessellation of the cells next to the component, and the vertices of its own.
  /// With `tells_parts` it says what it is made of.
  Handover of(std::span<const PlaceIndex> component, bool tells_parts = false) const;
  /// How some regions are shared among some cells, by basin, then by cell: what the cells have of
  /// them when these cells and no others report. `regions` are numbers among full(). The result
  /// depends on both lists alone, and normals play no part. Cost: the tessellation of `heirs`, and
  /// the vertices of the regions. Safe for several threads at once.
  std::vector<CellWeight> shared_among(std::span<const PlaceIndex> heirs,
                                       std::span<const std::uint32_t> regions) const;
  /// The numbers among full() of a cell's parts in the basins.
  std::vector<std::uint32_t> regions_of(PlaceIndex cell) const;

 private:
  using SharedRegions = std::vector<const Region*>;
  using Borders = std::vector<std::pair<PlaceIndex, PlaceIndex>>;
  /// Takes the shares of the heirs in one of the regions; it is called region by region. Places are
  /// positions in the list of heirs.
  using Take = std::function<void(const Region&, const MeasuredShares&)>;
  /// The cells of each basin, and what normals' measures say of them.
  struct Clipped {
    std::vector<ClippedCell> cells;
    std::vector<double> figures;
  };

  std::vector<PlaceIndex> heirs_of(std::span<const PlaceIndex> component) const;
  void add_regions(std::vector<Clipped> clipped);
  /// A piece of ground that is handed over.
  struct MeasuredGround {
    double weight;
    double area;
    std::span<const double> figures;
  };
  void add_normals(const std::vector<Clipped>& clipped);
  void add_normals(WeightedNormals& weighted, std::uint32_t basin,
                   const MeasuredGround& ground) const;
  std::span<const double> edge_figures_of(const Region& region) const;
  Borders share(const SharedRegions& regions, std::span<const PlaceIndex> heirs,
                const Take& take) const;
  std::optional<Borders> share_in_chart(const SharedRegions& regions, std::span<const Point> heirs,
                                        const Take& take) const;
  Borders share_on_surface(const SharedRegions& regions, std::span<const Point> heirs,
                           const Take& take) const;

  const Weighing& weighing_;
  NetworkCells cells_;
  CellAdjacency adjacency_;
  std::vector<CellWeight> full_;
  WeightedNormals full_normals_;
  std::vector<double> full_means_;            // the mean normals of full_, as full_normals_
  bool lacks_normals_ = false;                // whether some ground has none
  std::vector<std::vector<Region>> regions_;  // by cell, in the order of the basins
};

}  // namespace thiessen
