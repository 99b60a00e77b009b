#include "rainfall/totals/surrounding_rain.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace thiessen {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double at_the_place = std::numeric_limits<double>::infinity();

/// Sums the nearest places that report, up to as many as count.
class Sum {
 public:
  bool is_full() const { return count_ == SurroundingRain::most || is_here_; }
  void add(double weight, double rain) {
    if (weight == at_the_place) {
      is_here_ = true;
      rain_ = rain;
      weights_ = 1;
    } else {
      rain_ += weight * rain;
      weights_ += weight;
    }
    ++count_;
  }
  double mean() const { return count_ == 0 ? unknown : rain_ / weights_; }

 private:
  std::size_t count_ = 0;
  bool is_here_ = false;
  double rain_ = 0;
  double weights_ = 0;
};

}  // namespace

SurroundingRain::SurroundingRain(const Weighing& weighing)
    : weighing_(weighing),
      nearest_(weighing.network().places(), weighing.yardstick().metric),
      have_reported_(weighing.network().places().size(), false),
      neighbourhoods_(weighing.network().places().size()),
      counts_(weighing.network().places().size()) {
  for (std::uint32_t p = 0; p < have_reported_.size(); ++p) have_not_.push_back(PlaceIndex{p});
  if (weighing.yardstick().metric != Metric::geodesic) return;
  for (const Point p : weighing.network().places()) on_earth_.emplace_back(p);
}

std::vector<double> SurroundingRain::by_place(std::span<const double> readings,
                                              const NormalMonth& month) {
  // Where each gauge has a place of its own, places are numbered as gauges are.
  const bool are_places = weighing_.network().places().size() == readings.size();
  std::vector<double> rain = are_places && weighing_.normals() == nullptr
                                 ? std::vector<double>(readings.begin(), readings.end())
                                 : means_by_place(readings, month);
  std::erase_if(have_not_, [&](PlaceIndex place) {
    if (std::isnan(rain[index(place)])) return false;
    have_reported_.set(place, true);
    ++reported_;
    return true;
  });
  return rain;
}

std::vector<double> SurroundingRain::means_by_place(std::span<const double> readings,
                                                    const NormalMonth& month) {
  const Network& network = weighing_.network();
  const NormalField* const normals = weighing_.normals();
  std::vector<double> rain(network.places().size(), unknown);
  std::fill(counts_.begin(), counts_.end(), 0);
  for (std::uint32_t s = 0; s < readings.size(); ++s) {
    if (std::isnan(readings[s])) continue;
    const StationIndex station{s};
    const std::size_t place = index(network.place_of(station));
    const double relative = normals == nullptr
                                ? readings[s]
                                : readings[s] / relative_at_gauge(*normals, station, month);
    rain[place] = counts_[place]++ == 0 ? relative : rain[place] + relative;
  }
  for (std::size_t p = 0; p < rain.size(); ++p) {
    if (counts_[p] > 1) rain[p] /= static_cast<double>(counts_[p]);
  }
  return rain;
}

double SurroundingRain::at(StationIndex gauge, std::span<const double> by_place,
                           const NormalMonth& month) {
  const PlaceIndex place = weighing_.network().place_of(gauge);
  const Neighbourhood& kept_here = around(place);
  Sum sum;
  for (const Neighbour& neighbour : kept_here.near) {
    const double rain = by_place[index(neighbour.place)];
    if (std::isnan(rain)) continue;
    sum.add(neighbour.weight, rain);
    if (sum.is_full()) break;
  }
  const bool has_all = kept_here.near.size() == reported_;
  const double mean = sum.is_full() || has_all ? sum.mean() : searched(place, by_place);
  const NormalField* const normals = weighing_.normals();
  return normals == nullptr ? mean : mean * relative_at_gauge(*normals, gauge, month);
}

/// The same of whatever places report, where those that are kept are too few.
double SurroundingRain::searched(PlaceIndex from, std::span<const double> by_place) {
  ReportingPlaces reports(by_place.size(), false);
  for (std::uint32_t p = 0; p < by_place.size(); ++p)
    reports.set(PlaceIndex{p}, !std::isnan(by_place[p]));
  nearest_.find(weighing_.network().places()[index(from)], most, reports, found_);
  std::vector<Neighbour> near;
  for (const NearestGauges::Near& one : found_) near.push_back({one.place, one.square});
  weigh(from, near);
  Sum sum;
  for (const Neighbour& neighbour : near) {
    if (sum.is_full()) break;
    sum.add(neighbour.weight, by_place[index(neighbour.place)]);
  }
  return sum.mean();
}

/// The places near one, of those that have reported so far.
const SurroundingRain::Neighbourhood& SurroundingRain::around(PlaceIndex place) {
  Neighbourhood& here = neighbourhoods_[index(place)];
  if (here.of == reported_) return here;
  nearest_.find(weighing_.network().places()[index(place)], kept, have_reported_, found_);
  here.near.clear();
  for (const NearestGauges::Near& one : found_) here.near.push_back({one.place, one.square});
  weigh(place, here.near);
  here.of = reported_;
  return here;
}

/// Makes weights of the squares of distances that stand in their place. They are relative to the
/// nearest one's, so that no unit of length makes them too large or too small.
void SurroundingRain::weigh(PlaceIndex from, std::vector<Neighbour>& near) const {
  constexpr double accuracy = 1e-3;  // metres
  double least = 0;
  for (Neighbour& neighbour : near) {
    double square = neighbour.weight;
    if (!on_earth_.empty() && square > 0) {
      const double distance =
          arrival(on_earth_[index(neighbour.place)], on_earth_[index(from)], accuracy).distance;
      square = distance * distance;
    }
    if (least == 0) least = square;
    neighbour.weight = square == 0 ? at_the_place : least / square;
  }
}

}  // namespace thiessen
