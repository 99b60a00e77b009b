#include "rainfall/handover.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "base/parallel.h"
#include "geometry/long_sum.h"

namespace thiessen {

Handovers::Handovers(const Weighing& weighing, unsigned threads)
    : weighing_(weighing),
      cells_(weighing.network(), std::vector<bool>(weighing.network().stations().size(), true),
             weighing.ground(), weighing.frame(), threads),
      adjacency_(cells_.diagram()),
      regions_(cells_.diagram().places.size()) {
  if (!cells_.any()) return;
  std::vector<std::vector<ClippedCell>> clipped(weighing.basins().size());
  std::vector<std::unique_ptr<CellClipper>> clippers(std::max(1u, threads));
  in_parallel(clipped.size(), threads, [&](std::size_t worker, std::size_t b) {
    auto& clipper = clippers[worker];
    if (!clipper) clipper = std::make_unique<CellClipper>(cells_.diagram(), weighing.surface());
    clipped[b] = clipper->cells(weighing.basins()[b]);
  });
  add_regions(std::move(clipped));
}

void Handovers::add_regions(std::vector<std::vector<ClippedCell>> clipped) {
  for (std::uint32_t b = 0; b < clipped.size(); ++b) {
    for (ClippedCell& cell : clipped[b]) {
      full_.push_back({b, cell.place, cell.area / weighing_.basin_area(b)});
      regions_[index(cell.place)].push_back(
          {b, {{}, std::move(cell.shape), std::move(cell.bulges)}, cell.area});
    }
  }
}

std::vector<BasinWeights> Handovers::full_weights() const {
  std::vector<BasinWeights> weights(weighing_.basins().size());
  for (std::size_t b = 0; b < weights.size(); ++b) weights[b].area = weighing_.basin_area(b);
  for (std::uint32_t cell = 0; cell < regions_.size(); ++cell) {
    for (const Region& region : regions_[cell]) {
      add_shares(weights[region.basin], cells_.stations_of(PlaceIndex{cell}), region.area);
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

Handover Handovers::of(std::span<const PlaceIndex> component) const {
  Box frame;
  bool has_ground = false;
  for (const PlaceIndex cell : component) {
    for (const Region& region : regions_[index(cell)]) {
      has_ground = true;
      for (const Polygon& part : region.ground.shape) {
        for (const Point p : part.outer) frame.take_in(p);
      }
    }
  }
  const std::vector<PlaceIndex> heirs = heirs_of(component);
  if (!has_ground || heirs.empty()) return {};
  std::vector<Point> positions;
  positions.reserve(heirs.size());
  for (const PlaceIndex cell : heirs) positions.push_back(cells_.diagram().places[index(cell)]);
  const Diagram diagram = weighing_.ground().diagram_for_areas(positions, frame);
  CellClipper clipper(diagram, weighing_.surface());
  std::map<std::pair<std::uint32_t, PlaceIndex>, LongSum> areas;
  for (const PlaceIndex cell : component) {
    for (const Region& region : regions_[index(cell)]) {
      for (const CellShare& share : clipper.shares(region.ground))
        areas[{region.basin, heirs[index(share.place)]}].add(share.area);
    }
  }
  Handover handover;
  handover.reserve(areas.size());
  for (const auto& [key, area] : areas)
    handover.push_back({key.first, key.second, area.value() / weighing_.basin_area(key.first)});
  return handover;
}

}  // namespace thiessen
