#include "rainfall/findings/shift_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace thiessen {
namespace {

using Bits = Stretch::Bits;

/// So many stretches are taken one by one, 22 years of days, and of those beyond each eighth.
constexpr std::size_t stretches_taken = 128;
/// A square of a correlation beyond which no neighbour counts more.
constexpr double most_certain = 0.96;

template <typename Do>
void for_each_bit(Bits bits, Do&& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace

double ShiftSearch::Sums::correlation() const {
  const double covariance = steps * products - first * second;
  const double variances =
      (steps * first_squares - first * first) * (steps * second_squares - second * second);
  return variances > 0 ? covariance / std::sqrt(variances)
                       : std::numeric_limits<double>::quiet_NaN();
}

ShiftSearch::ShiftSearch(const GaugeNeighbours& neighbours)
    : neighbours_(neighbours), sums_(neighbours.pairs().size()), totals_(neighbours.gauges()) {}

void ShiftSearch::take_roots(const Stretch& stretch) {
  stride_ = stretch.stride();
  roots_.resize(totals_.size() * stride_);
  for (std::size_t g = 0; g < totals_.size(); ++g) {
    totals_[g] = 0;
    for_each_bit(stretch.wet(g), [&](std::size_t step) {
      const double root = std::sqrt(stretch.amount(g, step));
      roots_[g * stride_ + step] = root;
      totals_[g] += root;
    });
  }
}

/// Adds the products of a gauge's readings and another's so many steps later, 0 or 1.
void ShiftSearch::add(const Stretch& stretch, std::size_t earlier, std::size_t later,
                      std::size_t steps_later, Sums& sums) const {
  const Bits both = stretch.reports(earlier) & (stretch.reports(later) >> steps_later);
  if (both == 0) return;
  const Bits both_later = both << steps_later;
  sums.steps += std::popcount(both);
  const auto roots_of = [&](std::size_t gauge, Bits steps) {
    double sum = totals_[gauge];
    for_each_bit(stretch.wet(gauge) & ~steps,
                 [&](std::size_t at) { sum -= roots_[gauge * stride_ + at]; });
    return sum;
  };
  sums.first += roots_of(earlier, both);
  sums.second += roots_of(later, both_later);
  sums.first_squares += stretch.sum(earlier, both);
  sums.second_squares += stretch.sum(later, both_later);
  const double* const of_earlier = &roots_[earlier * stride_];
  const double* const of_later = &roots_[later * stride_ + steps_later];
  double products = 0;
  for_each_bit(stretch.wet(earlier) & (stretch.wet(later) >> steps_later) & both,
               [&](std::size_t at) { products += of_earlier[at] * of_later[at]; });
  sums.products += products;
}

void ShiftSearch::see(const Stretch& stretch) {
  if (++stretches_ > stretches_taken && stretches_ % 8 != 0) return;
  take_roots(stretch);
  const Lag forward = stretch.descends() ? second_earlier : second_later;
  const Lag backward = stretch.descends() ? second_later : second_earlier;
  for (std::size_t p = 0; p < sums_.size(); ++p) {
    const std::size_t a = index(neighbours_.pairs()[p].first);
    const std::size_t b = index(neighbours_.pairs()[p].second);
    if ((stretch.wet(a) | stretch.wet(b)) == 0 && stretch.reports(a) == stretch.reports(b)) {
      const int steps = std::popcount(stretch.reports(a));
      const int pairs_of_steps = std::popcount(stretch.reports(a) & (stretch.reports(a) >> 1));
      sums_[p][none].steps += steps;
      sums_[p][forward].steps += pairs_of_steps;
      sums_[p][backward].steps += pairs_of_steps;
      continue;
    }
    add(stretch, a, b, 0, sums_[p][none]);
    add(stretch, a, b, 1, sums_[p][forward]);
    add(stretch, b, a, 1, sums_[p][backward]);
  }
}

ShiftSearch::Gain ShiftSearch::gain(StationIndex gauge) const {
  double weights = 0;
  std::size_t telling = 0;
  Gain found;
  for (const GaugeNeighbours::Neighbour& neighbour : neighbours_.of(gauge)) {
    const std::array<Sums, 3>& sums = sums_[neighbour.pair];
    if (sums[none].steps < static_cast<double>(least_steps)) continue;
    const double together = sums[none].correlation();
    const double late = sums[neighbour.is_second ? second_later : second_earlier].correlation();
    const double early = sums[neighbour.is_second ? second_earlier : second_later].correlation();
    if (std::isnan(together) || std::isnan(late) || std::isnan(early)) continue;
    ++telling;
    const double best = std::max({together, late, early});
    const double weight = best > 0 ? best * best / (1 - std::min(best * best, most_certain)) : 0;
    weights += weight;
    found.where_late += weight * (late - together);
    found.where_early += weight * (early - together);
  }
  if (telling < least_neighbours || weights == 0) return {};
  return {found.where_late / weights, found.where_early / weights};
}

void ShiftSearch::conclude(const TakeFinding& take) {
  for (std::uint32_t g = 0; g < neighbours_.gauges(); ++g) {
    const Gain found = gain(StationIndex{g});
    if (!(std::max(found.where_late, found.where_early) > least_gain)) continue;
    const double late = found.where_late >= found.where_early ? 1.0 : -1.0;
    take({StationIndex{g}, FindingKind::shift, "", late, 0});
  }
}

}  // namespace thiessen
