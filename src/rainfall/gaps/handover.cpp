#include "rainfall/gaps/handover.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "earth/cells/chart_diagram.h"
#include "geometry/long_sum.h"
#include "rainfall/gaps/known_edges.h"

namespace thiessen {
namespace {

/// The share of a region's area by which its shares in a chart may miss it. A chart's shapes are
/// right to a hundredth of this.
constexpr double most_astray = 1e-4;

/// The nodes that only bend an edge between two cells and end none, in rising order. At a pole each
/// edge has a node of its own, which ends it.
std::vector<Point> bends_of(const Diagram& diagram) {
  struct Passing {
    std::uint8_t chords = 0;
    PlaceIndex left{};
    PlaceIndex right{};
  };
  std::vector<Passing> passing(diagram.nodes.size());
  constexpr std::uint8_t corner = 3;
  const auto pass = [&](std::uint32_t node, const Chord& chord) {
    Passing& here = passing[node];
    const bool is_same = here.chords == 0 || (here.left == chord.left && here.right == chord.right);
    here.chords = is_same ? static_cast<std::uint8_t>(here.chords + 1) : corner;
    here.left = chord.left;
    here.right = chord.right;
  };
  for (const Chord& chord : diagram.chords) {
    pass(chord.from, chord);
    pass(chord.to, chord);
  }
  std::vector<Point> bends;
  for (std::size_t node = 0; node < passing.size(); ++node) {
    if (passing[node].chords == 2 && std::abs(diagram.nodes[node].y) != 90)
      bends.push_back(diagram.nodes[node]);
  }
  std::sort(bends.begin(), bends.end());
  return bends;
}

/// The measure of a basin's normals; null where there is nothing to measure.
const GroundMeasure* measure_of(const NormalField* normals, std::size_t basin) {
  return normals == nullptr ? nullptr : normals->in(basin).measure();
}

/// The sum of pieces of ground.
struct GroundSum {
  LongSum area;
  std::vector<double> figures = {};

  void add(double piece, std::span<const double> of_piece) {
    area.add(piece);
    figures.resize(of_piece.size());
    for (std::size_t f = 0; f < of_piece.size(); ++f) figures[f] += of_piece[f];
  }
};

}  // namespace

Handovers::Handovers(const Weighing& weighing, unsigned threads)
    : weighing_(weighing),
      cells_(weighing.network(), ReportingStations(weighing.network().stations().size(), true),
             weighing.yardstick(), weighing.frame(), threads),
      adjacency_(cells_.diagram()),
      regions_(cells_.diagram().places.size()) {
  if (!cells_.any()) return;
  std::vector<Clipped> clipped(weighing.basins().size());
  std::vector<std::unique_ptr<CellClipper>> clippers(std::max(1u, threads));
  in_parallel(clipped.size(), threads, [&](std::size_t worker, std::size_t b) {
    auto& clipper = clippers[worker];
    if (!clipper) clipper = std::make_unique<CellClipper>(cells_.diagram(), weighing.surface());
    const GroundMeasure* const measure = measure_of(weighing.normals(), b);
    clipped[b].cells = measure == nullptr
                           ? clipper->cells(weighing.basins()[b])
                           : clipper->cells(weighing.basins()[b], *measure, clipped[b].figures);
  });
  if (weighing.normals() != nullptr) add_normals(clipped);
  add_regions(std::move(clipped));
}

// The weights are those of add_regions, in its order.
void Handovers::add_normals(const std::vector<Clipped>& clipped) {
  const std::vector<NormalMonth> all = months_of(normals());
  full_normals_.months = all.size();
  for (std::size_t b = 0; b < clipped.size(); ++b) {
    MeasuredShares ground;
    ground.figures = clipped[b].figures;
    for (const ClippedCell& cell : clipped[b].cells)
      ground.shares.push_back({cell.place, cell.area});
    std::vector<std::vector<double>> means;
    means.reserve(all.size());
    for (const NormalMonth& month : all)
      means.push_back(mean_normals(*normals(), b, ground, month));
    for (std::size_t i = 0; i < ground.shares.size(); ++i) {
      const double area = ground.shares[i].area;
      for (std::size_t m = 0; m < all.size(); ++m) {
        const double share = normal_over(*normals(), b, ground.figures_of(i), area, all[m]).covered;
        full_means_.push_back(means[m][i]);
        full_normals_.normals.push_back(area / weighing_.basin_area(b) *
                                        (means[m][i] / reference_normal(*normals(), all[m])));
        full_normals_.covered.push_back(share);
        lacks_normals_ = lacks_normals_ || share < 1;
      }
    }
  }
  if (!lacks_normals_) full_normals_.covered.clear();
}

void Handovers::add_regions(std::vector<Clipped> clipped) {
  const bool on_earth = weighing_.yardstick().metric == Metric::geodesic;
  const std::vector<Point> bends = on_earth ? bends_of(cells_.diagram()) : std::vector<Point>{};
  for (std::uint32_t b = 0; b < clipped.size(); ++b) {
    for (ClippedCell& cell : clipped[b].cells) {
      full_.push_back({b, cell.place, cell.area / weighing_.basin_area(b)});
      Region region{
          b, {{}, std::move(cell.shape), std::move(cell.bulges)}, cell.area, {}, full_.size() - 1};
      if (on_earth) region.shape.emplace(region.ground, bends, Yardstick::measuring_tolerance);
      regions_[index(cell.place)].push_back(std::move(region));
    }
  }
}

std::vector<BasinWeights> Handovers::full_weights(const NormalMonth& month) const {
  std::vector<BasinWeights> weights(weighing_.basins().size());
  for (std::size_t b = 0; b < weights.size(); ++b) weights[b].area = weighing_.basin_area(b);
  for (std::uint32_t cell = 0; cell < regions_.size(); ++cell) {
    for (const Region& region : regions_[cell]) {
      add_shares(weights[region.basin], cells_.stations_of(PlaceIndex{cell}), region.area);
      if (normals() == nullptr) continue;
      const std::size_t figure = region.number * full_normals_.months + place_of(normals(), month);
      const double normal = full_means_[figure];
      set_factors(weights[region.basin], cells_.stations_of(PlaceIndex{cell}), normal, *normals(),
                  month);
    }
  }
  for (BasinWeights& basin : weights) sort_by_station(basin.stations);
  return weights;
}

std::vector<PlaceIndex> Handovers::heirs_of(std::span<const PlaceIndex> component) const {
  std::vector<PlaceIndex> heirs;
  for (const PlaceIndex cell : component) {
    const auto next = adjacency_.neighbours(cell);
    heirs.insert(heirs.end(), next.begin(), next.end());
  }
  std::sort(heirs.begin(), heirs.end());
  heirs.erase(std::unique(heirs.begin(), heirs.end()), heirs.end());
  std::erase_if(heirs, [&](PlaceIndex cell) {
    return std::binary_search(component.begin(), component.end(), cell);
  });
  return heirs;
}

Handover Handovers::of(std::span<const PlaceIndex> component, bool tells_parts) const {
  SharedRegions regions;
  for (const PlaceIndex cell : component) {
    for (const Region& region : regions_[index(cell)]) regions.push_back(&region);
  }
  std::vector<PlaceIndex> heirs = heirs_of(component);
  Handover handover;
  if (regions.empty()) {
    if (tells_parts) handover.made_of.unmeasured = std::move(heirs);
    return handover;
  }
  if (heirs.empty()) return handover;
  std::map<std::pair<std::uint32_t, PlaceIndex>, GroundSum> grounds;
  const Take take = [&](const Region& region, const MeasuredShares& taken) {
    for (std::size_t i = 0; i < taken.shares.size(); ++i) {
      const PlaceIndex heir = heirs[index(taken.shares[i].place)];
      grounds[{region.basin, heir}].add(taken.shares[i].area, taken.figures_of(i));
      if (!tells_parts) continue;
      handover.made_of.parts.push_back({static_cast<std::uint32_t>(region.number), heir,
                                        taken.shares[i].area / weighing_.basin_area(region.basin)});
    }
  };
  Borders borders = share(regions, heirs, take);
  handover.shares.reserve(grounds.size());
  for (const auto& [key, ground] : grounds) {
    const double area = ground.area.value();
    const double weight = area / weighing_.basin_area(key.first);
    handover.shares.push_back({key.first, key.second, weight});
    add_normals(handover.weighted, key.first, {weight, area, ground.figures});
  }
  if (!tells_parts) return handover;
  handover.made_of.borders.reserve(borders.size());
  for (const auto& [a, b] : borders) {
    // Among few places on the sphere one may stand on both sides of another.
    if (a != b) handover.made_of.borders.emplace_back(heirs[index(a)], heirs[index(b)]);
  }
  return handover;
}

std::vector<CellWeight> Handovers::shared_among(std::span<const PlaceIndex> heirs,
                                                std::span<const std::uint32_t> regions) const {
  SharedRegions ground;
  for (const std::uint32_t number : regions) {
    const std::vector<Region>& of_cell = regions_[index(full_[number].cell)];
    ground.push_back(&*std::find_if(of_cell.begin(), of_cell.end(),
                                    [&](const Region& r) { return r.number == number; }));
  }
  std::map<std::pair<std::uint32_t, PlaceIndex>, LongSum> areas;
  if (!heirs.empty()) {
    share(ground, heirs, [&](const Region& region, const MeasuredShares& taken) {
      for (const CellShare& share : taken.shares)
        areas[{region.basin, heirs[index(share.place)]}].add(share.area);
    });
  }
  std::vector<CellWeight> shares;
  shares.reserve(areas.size());
  for (const auto& [key, area] : areas)
    shares.push_back({key.first, key.second, area.value() / weighing_.basin_area(key.first)});
  return shares;
}

std::vector<std::uint32_t> Handovers::regions_of(PlaceIndex cell) const {
  std::vector<std::uint32_t> numbers;
  for (const Region& region : regions_[index(cell)])
    numbers.push_back(static_cast<std::uint32_t>(region.number));
  return numbers;
}

void Handovers::add_normals(WeightedNormals& weighted, std::uint32_t basin,
                            const MeasuredGround& ground) const {
  if (normals() == nullptr) return;
  const std::vector<NormalMonth> all = months_of(normals());
  weighted.months = all.size();
  for (std::size_t m = 0; m < all.size(); ++m) {
    const GroundNormal normal = normal_over(*normals(), basin, ground.figures, ground.area, all[m]);
    const double mean =
        std::isnan(normal.mean) ? basin_normal(*normals(), basin, all[m]) : normal.mean;
    weighted.normals.push_back(ground.weight * (mean / reference_normal(*normals(), all[m])));
    if (lacks_normals_) weighted.covered.push_back(normal.covered);
  }
}

// The edges of a region in charts are the same in all of them; in a plane they are those of its
// ground.
std::span<const double> Handovers::edge_figures_of(const Region& region) const {
  EdgeFigures& edges = *region.edges;
  std::call_once(edges.once, [&] {
    const BasinNormals& normals = this->normals()->in(region.basin);
    if (region.shape) {
      const GnomonicChart chart(region.shape->centre());
      edges.figures = figures_of_edges(region.shape->in_chart(chart), *normals.measure_in(chart));
    } else {
      edges.figures = figures_of_edges(region.ground, *normals.measure());
    }
  });
  return edges.figures;
}

Handovers::Borders Handovers::share(const SharedRegions& regions, std::span<const PlaceIndex> heirs,
                                    const Take& take) const {
  std::vector<Point> positions;
  positions.reserve(heirs.size());
  for (const PlaceIndex cell : heirs) positions.push_back(cells_.diagram().places[index(cell)]);
  if (auto borders = share_in_chart(regions, positions, take)) return std::move(*borders);
  return share_on_surface(regions, positions, take);
}

// Shares the ground in one chart, which is possible on the Earth where the ground is small against
// it; else returns nothing. The shares of each region are scaled so that they add up to its area,
// which is known.
std::optional<Handovers::Borders> Handovers::share_in_chart(const SharedRegions& regions,
                                                            std::span<const Point> heirs,
                                                            const Take& take) const {
  if (weighing_.yardstick().metric == Metric::planar) return {};
  Box frame;
  Direction sum;
  for (const Region* region : regions) {
    frame.take_in(region->shape->box());
    sum = sum + region->shape->centre();
  }
  if (length(sum) == 0) return {};
  const GnomonicChart chart(unit(sum));
  double reach = 0;
  for (const Region* region : regions) {
    const double half = length(region->shape->centre() - chart.centre()) / 2;
    reach = std::max(reach, 2 * std::asin(std::min(1.0, half)) + region->shape->reach());
  }
  if (reach > SphereShape::farthest_reach) return {};
  auto diagram = chart_diagram(heirs, {chart, 1.1 * reach, frame},
                               {Yardstick::accuracy_of_heirs, Yardstick::measuring_tolerance});
  if (!diagram) return {};
  const ChartSurface surface(chart);
  CellClipper clipper(*diagram, surface);
  std::vector<std::pair<const Region*, MeasuredShares>> all;
  std::map<std::uint32_t, std::unique_ptr<const GroundMeasure>> measures;
  bool is_right = true;
  for (const Region* region : regions) {
    throw_if_interrupted();
    MeasuredShares& taken = all.emplace_back(region, MeasuredShares()).second;
    std::vector<CellShare>& shares = taken.shares;
    if (normals() == nullptr || normals()->in(region->basin).is_uniform()) {
      shares = clipper.shares(region->shape->in_chart(chart));
    } else {
      auto& measure = measures[region->basin];
      if (!measure) measure = normals()->in(region->basin).measure_in(chart);
      const Basin ground = region->shape->in_chart(chart);
      shares = clipper.shares(ground, KnownEdges(ground, edge_figures_of(*region), *measure),
                              taken.figures);
    }
    double whole = 0;
    for (const CellShare& share : shares) whole += share.area;
    is_right = is_right && std::abs(whole - region->area) <= most_astray * region->area;
    for (CellShare& share : shares) share.area *= region->area / whole;
  }
  // A sliver may be smaller than the rounding in a chart; then the ground is shared without one.
  if (!is_right) return {};
  for (const auto& [region, taken] : all) take(*region, taken);
  return std::move(diagram->neighbours);
}

Handovers::Borders Handovers::share_on_surface(const SharedRegions& regions,
                                               std::span<const Point> heirs,
                                               const Take& take) const {
  Box frame;
  for (const Region* region : regions) {
    for (const Polygon& part : region->ground.shape) {
      for (const Point p : part.outer) frame.take_in(p);
    }
  }
  Diagram diagram = weighing_.yardstick().diagram_of_heirs(heirs, frame);
  CellClipper clipper(diagram, weighing_.surface());
  for (const Region* region : regions) {
    throw_if_interrupted();
    MeasuredShares taken;
    const GroundMeasure* const measure = measure_of(normals(), region->basin);
    if (measure == nullptr) {
      taken.shares = clipper.shares(region->ground);
    } else if (region->shape) {
      taken.shares = clipper.shares(region->ground, *measure, taken.figures);
    } else {
      taken.shares = clipper.shares(region->ground,
                                    KnownEdges(region->ground, edge_figures_of(*region), *measure),
                                    taken.figures);
    }
    take(*region, taken);
  }
  return std::move(diagram.neighbours);
}

}  // namespace thiessen
