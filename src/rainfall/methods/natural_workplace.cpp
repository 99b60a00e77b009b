#include "rainfall/methods/natural_workplace.h"

#include <algorithm>
#include <utility>

namespace thiessen {

NaturalNeighbours::Workplace::Workplace(const NaturalNeighbours& all)
    : all_(all),
      natural_(all.full_.natural),
      all_but_(all.weighing_.network().places().size(), true),
      sums(all.weighing_.network().places().size()) {}

bool NaturalNeighbours::Workplace::find(const ChartPoint& at, Point position,
                                        const ReportingPlaces& reports,
                                        std::vector<Neighbour>& weights) {
  weights.clear();
  const bool is_inside = afresh_ ? afresh_->natural.find(afresh_->chart.at(position), gauges_)
                                 : natural_.find(at, gauges_);
  if (!is_inside) {
    all_.nearest_.find(position, 1, reports, near_);
    weights.push_back({near_.front().place, 1});
  }
  for (const NaturalWeight& w : gauges_) add_places(w, reports, weights);
  return is_inside;
}

NaturalNeighbours::Sums NaturalNeighbours::Workplace::sums_of(const Points& points,
                                                              const PointBlock& block,
                                                              std::size_t month,
                                                              const ReportingPlaces& reports) {
  begin_in(points, block, reports);
  for (std::uint32_t i = block.first_point; i < block.end_point; ++i) {
    find(points.at[i], points.positions[i], reports, found_);
    add(points, month, i, found_, sums);
  }
  return sums.take_sums();
}

// The last bits of weights may depend on where the search begins, and must not on what was looked
// for before.
void NaturalNeighbours::Workplace::begin_in(const Points& points, const PointBlock& block,
                                            const ReportingPlaces& reports) {
  if (afresh_) return afresh_->natural.begin_anew();
  for (std::uint32_t i = block.first_sum; i < block.end_sum; ++i) {
    const PlaceIndex place = points.blocks.sums.front()[i].place;
    if (reports[place]) return natural_.begin_at(all_.full_.natural.numbers()[index(place)]);
  }
  natural_.begin_anew();
}

bool NaturalNeighbours::Workplace::is_silent(PointId number, const ReportingPlaces& reports) const {
  const auto& places = all_.full_.places_of[index(number)];
  return std::none_of(places.begin(), places.end(), [&](PlaceIndex p) { return reports[p]; });
}

std::vector<PointId> NaturalNeighbours::Workplace::silent_numbers(
    const ReportingPlaces& reports) const {
  std::vector<PointId> silent;
  for (std::uint32_t n = 0; n < all_.full_.places_of.size(); ++n) {
    if (!all_.full_.places_of[n].empty() && is_silent(PointId{n}, reports))
      silent.push_back(PointId{n});
  }
  return silent;
}

void NaturalNeighbours::Workplace::add_places(const NaturalWeight& w,
                                              const ReportingPlaces& reports,
                                              std::vector<Neighbour>& weights) const {
  const std::size_t first = weights.size();
  for (const PlaceIndex p : (afresh_ ? *afresh_ : all_.full_).places_of[index(w.gauge)]) {
    if (reports[p]) weights.push_back({p, w.weight});
  }
  const auto count = static_cast<double>(weights.size() - first);
  for (std::size_t i = first; i < weights.size(); ++i) weights[i].weight /= count;
}

}  // namespace thiessen
