#include "map/raster/pixel_handovers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "map/raster/owners.h"

namespace thiessen {
namespace {

// Distances through the Earth rank places as geodesics do to a three hundredth at worst.
constexpr double ranks_alike = 1.01;

// A handover takes about so much memory, apart from its runs.
constexpr std::size_t bytes_apiece = 200;

// After so many answers of which a winner is silent, the silent places are asked for at once.
constexpr int most_questions = 4;

std::vector<Direction> in_space(const Network& network, const NearestPlaces& nearest) {
  std::vector<Direction> places;
  places.reserve(network.places().size());
  for (const Point p : network.places()) places.push_back(nearest.in_space(p));
  return places;
}

/// A rectangle that reaches beyond all pixels of the whole raster.
std::vector<MultiPolygon> everywhere(const PixelGrid& grid) {
  const Point a = grid.at(-1, -1);
  const Point b = grid.at(grid.columns + 1, grid.rows + 1);
  return {{{{a, {a.x, b.y}, b, {b.x, a.y}}, {}}}};
}

Network network_of(const Network& network, std::span<const PlaceIndex> places, Metric metric) {
  std::vector<Station> stations;
  stations.reserve(places.size());
  for (const PlaceIndex p : places) stations.push_back({"", network.places()[index(p)]});
  return {std::move(stations), metric};
}

}  // namespace

PixelHandovers::PixelHandovers(const PixelGrid& grid, const Network& network, Metric metric,
                               const PlaceRuns& runs, std::function<PointMapping()> to_study,
                               unsigned threads)
    : grid_(grid),
      network_(network),
      metric_(metric),
      runs_(runs),
      to_study_(std::move(to_study)),
      nearest_(nearest_places(network.places(), metric)),
      tree_(in_space(network, *nearest_)),
      cells_(network.places().size()),
      mappings_(std::max(1u, threads)) {}

const PointMapping& PixelHandovers::mapping_of(std::size_t worker) {
  if (!mappings_[worker]) mappings_[worker] = to_study_();
  return mappings_[worker];
}

std::span<const HandedRun> PixelHandovers::of(std::size_t worker, PlaceIndex silent,
                                              const ReportingPlaces& reports) {
  Cell& cell = cells_[index(silent)];
  Absent absent;
  for (int question = 0; question < most_questions; ++question) {
    auto known = cell.by_absent.find(absent);
    if (known == cell.by_absent.end()) {
      const auto is_absent = [&](PlaceIndex p) {
        return p == silent || std::binary_search(absent.begin(), absent.end(), p);
      };
      known = cell.by_absent.emplace(absent, hand_over(worker, silent, is_absent)).first;
      bytes_ += known->second.runs.size() * sizeof(HandedRun) + bytes_apiece;
    }
    const std::size_t before = absent.size();
    for (const PlaceIndex winner : known->second.winners) {
      if (!reports[winner]) absent.push_back(winner);
    }
    if (absent.size() == before) return known->second.runs;
    std::sort(absent.begin(), absent.end());
  }
  cell.last = hand_over(worker, silent, [&](PlaceIndex p) { return !reports[p]; });
  return cell.last.runs;
}

void PixelHandovers::forget_beyond(std::size_t bytes) {
  if (bytes_ <= bytes) return;
  for (Cell& cell : cells_) cell.by_absent.clear();
  bytes_ = 0;
}

PixelBlock PixelHandovers::box_of(PlaceIndex place) const {
  const auto columns = static_cast<std::uint32_t>(grid_.columns);
  const auto runs = runs_.of(place);
  std::uint32_t west = columns;
  std::uint32_t east = 0;
  for (const PixelRun& run : runs) {
    west = std::min(west, run.begin % columns);
    east = std::max(east, (run.end - 1) % columns + 1);
  }
  const std::uint32_t north = runs.front().begin / columns;
  const std::uint32_t south = (runs.back().end - 1) / columns + 1;
  return {static_cast<int>(west), static_cast<int>(north), static_cast<int>(east - west),
          static_cast<int>(south - north)};
}

double PixelHandovers::radius_of(std::size_t worker, PlaceIndex place) {
  const auto columns = static_cast<std::uint32_t>(grid_.columns);
  std::vector<Point> centres;
  centres.reserve(runs_.pixels_of(place));
  for (const PixelRun& run : runs_.of(place)) {
    for (std::uint32_t i = run.begin; i < run.end; ++i)
      centres.push_back(grid_.centre(static_cast<int>(i % columns), static_cast<int>(i / columns)));
  }
  mapping_of(worker)(centres);
  double radius = 0;
  for (const Point centre : centres)
    radius = std::max(radius, length(nearest_->in_space(centre) - tree_[place]));
  return radius;
}

std::vector<PlaceIndex> PixelHandovers::rivals_of(
    PlaceIndex place, double radius, const std::function<bool(PlaceIndex)>& is_absent) const {
  const Direction centre = tree_[place];
  const auto nearest_of = [&](const Ball& ball) {
    return length(ball.centre - centre) - ball.radius;
  };
  double nearest = HUGE_VAL;
  tree_.search([&](const Ball& ball) { return nearest_of(ball) > nearest; },
               [&](PlaceIndex p) {
                 const double distance = length(tree_[p] - centre);
                 if (distance < nearest && !is_absent(p)) nearest = distance;
               });
  std::vector<PlaceIndex> rivals;
  if (nearest == HUGE_VAL) return rivals;
  const double reach = ranks_alike * (2 * radius + nearest);
  tree_.search([&](const Ball& ball) { return nearest_of(ball) > reach; },
               [&](PlaceIndex p) {
                 if (length(tree_[p] - centre) <= reach && !is_absent(p)) rivals.push_back(p);
               });
  std::sort(rivals.begin(), rivals.end());
  return rivals;
}

PixelHandovers::Handover PixelHandovers::hand_over(
    std::size_t worker, PlaceIndex place, const std::function<bool(PlaceIndex)>& is_absent) {
  Cell& cell = cells_[index(place)];
  if (cell.radius < 0) {
    cell.radius = radius_of(worker, place);
    cell.box = box_of(place);
  }
  Handover handover;
  const std::vector<PlaceIndex> rivals = rivals_of(place, cell.radius, is_absent);
  if (rivals.empty()) return handover;
  const Network near = network_of(network_, rivals, metric_);
  Owners owners(
      grid_.part(cell.box), everywhere(grid_), near, metric_,
      ReportingStations(rivals.size(), true), [&] { return mapping_of(worker); }, 1);
  const std::span<const std::int32_t> box = owners.rows(0, cell.box.rows);
  const auto columns = static_cast<std::uint32_t>(grid_.columns);
  for (const PixelRun& run : runs_.of(place)) {
    const std::uint32_t row = run.begin / columns - static_cast<std::uint32_t>(cell.box.row);
    const std::uint32_t in_box = row * static_cast<std::uint32_t>(cell.box.columns) +
                                 run.begin % columns - static_cast<std::uint32_t>(cell.box.column);
    const auto some = box.subspan(in_box, run.end - run.begin);
    for (std::uint32_t i = 0; i < some.size();) {
      const std::uint32_t begin = i;
      while (i < some.size() && some[i] == some[begin]) ++i;
      if (some[begin] == 0) continue;  // the projection ends there
      const PlaceIndex owner = rivals[static_cast<std::size_t>(some[begin] - 1)];
      handover.runs.push_back({{run.begin + begin, run.begin + i}, owner});
      handover.winners.push_back(owner);
    }
  }
  std::sort(handover.winners.begin(), handover.winners.end());
  handover.winners.erase(std::unique(handover.winners.begin(), handover.winners.end()),
                         handover.winners.end());
  return handover;
}

}  // namespace thiessen
