#include "rainfall/network/weights.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "rainfall/network/network_cells.h"
#include "rainfall/normals/mean_normals.h"

namespace thiessen {
namespace {

Box box_of_all(const std::vector<Basin>& basins) {
  Box box;
  for (const Basin& basin : basins) {
    for (const Polygon& part : basin.shape) {
      for (const Point p : part.outer) box.take_in(p);
    }
  }
  return box;
}

/// What basins need of a plane's diagram to be laid over it. The cell in which a ring begins is
/// sought only where the ring lies in one cell, or nearly.
PlaneNeeds needs_of(const std::vector<Basin>& basins) {
  constexpr std::size_t few_rings = 8;
  PlaneNeeds needs{.ground = {}, .neighbours = false};
  std::size_t rings = 0;
  for (const Basin& basin : basins) {
    needs.ground.push_back(&basin.shape);
    for (const Polygon& part : basin.shape) rings += 1 + part.holes.size();
  }
  needs.near_is_seldom = rings <= few_rings;
  return needs;
}

Searches searches_in(const std::vector<Basin>& basins) {
  constexpr std::size_t few_edges = 6;
  std::size_t edges = 0;
  for (const Basin& basin : basins) {
    for (const Polygon& part : basin.shape) {
      edges += part.outer.size();
      for (const Ring& hole : part.holes) edges += hole.size();
    }
  }
  return edges <= few_edges ? Searches::few : Searches::many;
}

/// Gives the cells their measured areas; false where there are cells without area, or the reverse.
bool take_areas(std::vector<ClippedCell>& cells, const std::vector<CellShare>& shares) {
  const auto is_same = [](const ClippedCell& cell, const CellShare& share) {
    return cell.place == share.place;
  };
  if (!std::equal(cells.begin(), cells.end(), shares.begin(), shares.end(), is_same)) return false;
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i].area = shares[i].area;
  return true;
}

/// Gives the cells the factors of their gauges' weights. Both are in the order of the stations.
void take_factors(std::vector<std::vector<StationCell>>& cells,
                  const std::vector<BasinWeights>& weights) {
  for (std::size_t b = 0; b < cells.size(); ++b) {
    auto weight = weights[b].stations.begin();
    for (StationCell& cell : cells[b]) {
      while (weight != weights[b].stations.end() && weight->station < cell.station) ++weight;
      if (weight != weights[b].stations.end() && weight->station == cell.station)
        cell.factor = weight->factor;
    }
  }
}

}  // namespace

void add_shares(BasinWeights& basin, std::span<const StationIndex> stations, double area) {
  const double share = area / static_cast<double>(stations.size());
  for (const StationIndex s : stations)
    basin.stations.push_back({s, share, std::min(share / basin.area, 1.0)});
}

void set_factors(BasinWeights& basin, std::span<const StationIndex> stations, double normal,
                 const NormalField& normals, const NormalMonth& month) {
  for (std::size_t i = basin.stations.size() - stations.size(); i < basin.stations.size(); ++i) {
    StationWeight& part = basin.stations[i];
    part.factor = normal / normal_at_gauge(normals, part.station, month);
  }
}

Weighing::Weighing(const Network& network, const std::vector<Basin>& basins,
                   const std::vector<Basin>& drawn, const Yardstick& yardstick)
    : network_(network),
      basins_(basins),
      drawn_(drawn),
      yardstick_(yardstick),
      surface_(yardstick.surface()),
      frame_(box_of_all(basins)) {
  areas_.reserve(basins.size());
  for (const Basin& basin : basins) areas_.push_back(area_of(basin, *surface_));
}

/// The cells of the reporting gauges with edges of one kind, and the clippers of the threads: each
/// has its own, for a clipper is not safe for several.
class Weighing::Clipping {
 public:
  Clipping(const Weighing& weighing, const ReportingStations& reports, unsigned threads,
           Edges edges)
      : Clipping(weighing, reports, threads, edges, weighing.yardstick_) {}
  Clipping(const Weighing& weighing, const ReportingStations& reports, unsigned threads,
           Edges edges, const Yardstick& yardstick)
      : surface_(*weighing.surface_),
        basins_(edges == Edges::drawn ? weighing.drawn_ : weighing.basins_),
        cells_(weighing.network_, reports, yardstick,
               edges == Edges::drawn ? box_of_all(weighing.drawn_) : weighing.frame_, threads,
               edges, needs_of(basins_)),
        clippers_(std::max(1u, threads)) {}

  bool any() const { return cells_.any(); }
  std::span<const StationIndex> stations_of(PlaceIndex place) const {
    return cells_.stations_of(place);
  }
  std::vector<CellShare> shares(std::size_t worker, std::size_t basin) {
    return clipper(worker).shares(basins_[basin]);
  }
  std::vector<CellShare> shares(std::size_t worker, std::size_t basin, const GroundMeasure& measure,
                                std::vector<double>& figures) {
    return clipper(worker).shares(basins_[basin], measure, figures);
  }
  std::vector<ClippedCell> cells(std::size_t worker, std::size_t basin) {
    return clipper(worker).cells(basins_[basin]);
  }
  CellsInBasin cells_in(std::size_t basin) { return clipper(0).cells_in(basins_[basin]); }

 private:
  CellClipper& clipper(std::size_t worker) {
    auto& clipper = clippers_[worker];
    if (!clipper)
      clipper = std::make_unique<CellClipper>(cells_.diagram(), surface_, searches_in(basins_));
    return *clipper;
  }

  const Surface& surface_;
  const std::vector<Basin>& basins_;
  NetworkCells cells_;
  std::vector<std::unique_ptr<CellClipper>> clippers_;
};

std::vector<BasinWeights> Weighing::weights(const ReportingStations& reports,
                                            unsigned threads) const {
  return weights_in_month(reports, threads, {});
}

std::vector<BasinWeights> Weighing::weights_in_month(const ReportingStations& reports,
                                                     unsigned threads,
                                                     const NormalMonth& month) const {
  const bool tells_months = normals_ != nullptr && normals_->months() > 1;
  return std::move(weights_in({tells_months ? month : NormalMonth()}, reports, threads).front());
}

std::vector<std::vector<BasinWeights>> Weighing::weights_by_month(const ReportingStations& reports,
                                                                  unsigned threads) const {
  std::vector<NormalMonth> months;
  for (std::size_t m = 0; normals_ != nullptr && m < normals_->months(); ++m)
    months.emplace_back(m);
  if (months.size() < 2) months = {NormalMonth()};
  return weights_in(months, reports, threads);
}

std::vector<std::vector<BasinWeights>> Weighing::weights_in(const std::vector<NormalMonth>& months,
                                                            const ReportingStations& reports,
                                                            unsigned threads) const {
  std::vector<std::vector<BasinWeights>> all(months.size());
  for (std::vector<BasinWeights>& weights : all) {
    weights.resize(basins_.size());
    for (std::size_t b = 0; b < basins_.size(); ++b) weights[b].area = areas_[b];
  }
  Clipping measured(*this, reports, threads, Edges::measured);
  if (!measured.any()) return all;
  in_parallel(basins_.size(), threads, [&](std::size_t worker, std::size_t b) {
    const GroundMeasure* const measure = normals_ == nullptr ? nullptr : normals_->in(b).measure();
    MeasuredShares ground;
    ground.shares = measure == nullptr ? measured.shares(worker, b)
                                       : measured.shares(worker, b, *measure, ground.figures);
    for (std::size_t m = 0; m < months.size(); ++m) {
      BasinWeights& basin = all[m][b];
      const std::vector<double> means = normals_ == nullptr
                                            ? std::vector<double>()
                                            : mean_normals(*normals_, b, ground, months[m]);
      for (std::size_t i = 0; i < ground.shares.size(); ++i) {
        const auto stations = measured.stations_of(ground.shares[i].place);
        add_shares(basin, stations, ground.shares[i].area);
        if (normals_ != nullptr) set_factors(basin, stations, means[i], *normals_, months[m]);
      }
      sort_by_station(basin.stations);
    }
  });
  return all;
}

std::vector<std::vector<StationCell>> Weighing::cells(const ReportingStations& reports,
                                                      unsigned threads,
                                                      const NormalMonth& month) const {
  std::vector<std::vector<StationCell>> all(basins_.size());
  Clipping measured(*this, reports, threads, Edges::measured);
  if (!measured.any()) return all;
  std::optional<Clipping> drawn;
  if (!yardstick_.draws_as_measured()) drawn.emplace(*this, reports, threads, Edges::drawn);
  in_parallel(basins_.size(), threads, [&](std::size_t worker, std::size_t b) {
    std::vector<ClippedCell> clipped;
    if (drawn) clipped = drawn->cells(worker, b);
    if (!drawn || !take_areas(clipped, measured.shares(worker, b)))
      clipped = measured.cells(worker, b);
    all[b] = by_station(clipped, measured, b);
  });
  if (normals_ != nullptr) take_factors(all, weights_in_month(reports, threads, month));
  return all;
}

std::vector<StationCell> Weighing::by_station(const std::vector<ClippedCell>& cells,
                                              const Clipping& clipping, std::size_t basin) const {
  std::vector<StationCell> found;
  for (const ClippedCell& cell : cells) {
    throw_if_interrupted();
    const auto stations = clipping.stations_of(cell.place);
    const double area = cell.area / static_cast<double>(stations.size());
    for (const StationIndex s : stations)
      found.push_back({s, area, std::min(area / areas_[basin], 1.0), cell.shape});
  }
  sort_by_station(found);
  return found;
}

/// Hands over cells until no more are wanted.
class Weighing::CellsHandedOver {
 public:
  using Take = std::function<bool(std::size_t basin, StationCell&& cell)>;

  CellsHandedOver(const Weighing& weighing, const Take& take) : weighing_(weighing), take_(take) {}

  bool goes_on() const { return goes_on_; }
  void hand_over(std::size_t basin, std::vector<StationCell> cells) {
    for (std::size_t i = 0; goes_on_ && i < cells.size(); ++i)
      goes_on_ = take_(basin, std::move(cells[i]));
  }
  /// Makes each cell when it is its turn, in the order of the stations.
  void make(std::size_t basin, Clipping& clipping) {
    CellsInBasin cells = clipping.cells_in(basin);
    std::vector<std::pair<StationIndex, std::uint32_t>> turns;
    turns.reserve(cells.shares().size());
    for (std::uint32_t i = 0; i < cells.shares().size(); ++i) {
      for (const StationIndex s : clipping.stations_of(cells.shares()[i].place))
        turns.emplace_back(s, i);
    }
    std::sort(turns.begin(), turns.end());
    constexpr std::size_t far = 16;
    constexpr std::size_t near = 6;
    for (std::size_t t = 0; goes_on_ && t < turns.size(); ++t) {
      throw_if_interrupted();
      if (t + far < turns.size()) cells.expect_far(turns[t + far].second);
      if (t + near < turns.size()) cells.expect_near(turns[t + near].second);
      ClippedCell cell = cells.cell(turns[t].second);
      const auto sharing = static_cast<double>(clipping.stations_of(cell.place).size());
      const double area = cell.area / sharing;
      const double weight = std::min(area / weighing_.areas_[basin], 1.0);
      goes_on_ = take_(basin, {turns[t].first, area, weight, std::move(cell.shape)});
    }
  }

 private:
  const Weighing& weighing_;
  const Take& take_;
  bool goes_on_ = true;
};

void Weighing::for_each_cell(
    const ReportingStations& reports, unsigned threads, const NormalMonth& month,
    const std::function<bool(std::size_t basin, StationCell&& cell)>& take) const {
  CellsHandedOver handed(*this, take);
  if (!yardstick_.draws_as_measured() || normals_ != nullptr) {
    std::vector<std::vector<StationCell>> all = cells(reports, threads, month);
    for (std::size_t b = 0; b < all.size(); ++b) handed.hand_over(b, std::move(all[b]));
    return;
  }
  Clipping measured(*this, reports, threads, Edges::measured);
  if (!measured.any()) return;
  const std::size_t at_once = threads > 1 && basins_.size() > 1 ? 64 : 1;
  std::vector<std::vector<StationCell>> some(at_once);
  for (std::size_t first = 0; handed.goes_on() && first < basins_.size(); first += at_once) {
    if (at_once == 1) {
      handed.make(first, measured);
      continue;
    }
    const std::size_t count = std::min(at_once, basins_.size() - first);
    in_parallel(count, threads, [&](std::size_t worker, std::size_t i) {
      some[i] = by_station(measured.cells(worker, first + i), measured, first + i);
    });
    for (std::size_t i = 0; i < count; ++i) handed.hand_over(first + i, std::move(some[i]));
  }
}

std::vector<std::vector<StationCell>> Weighing::pictured_cells(const ReportingStations& reports,
                                                               double tolerance, unsigned threads,
                                                               const NormalMonth& month) const {
  std::vector<std::vector<StationCell>> all(basins_.size());
  Yardstick yardstick = yardstick_;
  yardstick.tolerance = tolerance;
  Clipping drawn(*this, reports, threads, Edges::drawn, yardstick);
  if (!drawn.any()) return all;
  in_parallel(basins_.size(), threads, [&](std::size_t worker, std::size_t b) {
    all[b] = by_station(drawn.cells(worker, b), drawn, b);
  });
  if (normals_ != nullptr) take_factors(all, weights_in_month(reports, threads, month));
  return all;
}

}  // namespace thiessen
