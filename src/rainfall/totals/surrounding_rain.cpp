#include "rainfall/totals/surrounding_rain.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "earth/nearest/in_space.h"

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
  for (const Point p : weighing.network().places())
    in_space_.push_back(in_space(p, weighing.yardstick().metric));
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
    reporters_.push_back(place);
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
  const NormalField* const normals = weighing_.normals();
  const double normal = normals == nullptr ? 1 : relative_at_gauge(*normals, gauge, month);
  while (true) {
    const Neighbourhood& here = around(place);
    Sum sum;
    for (const Neighbour& neighbour : here.near) {
      const double rain = by_place[index(neighbour.place)];
      if (std::isnan(rain)) continue;
      sum.add(neighbour.weight, rain);
      if (sum.is_full()) break;
    }
    if (sum.is_full() || here.near.size() == reporters_.size()) return sum.mean() * normal;
    if (here.wanted == kept_at_most) return searched(place, by_place) * normal;
    Neighbourhood& wider = neighbourhoods_[index(place)];
    wider.wanted *= 4;
    find(place, wider);
  }
}

/// The same of whatever places report, where those that are kept are too few.
double SurroundingRain::searched(PlaceIndex from, std::span<const double> by_place) {
  ReportingPlaces reports(by_place.size(), false);
  for (std::uint32_t p = 0; p < by_place.size(); ++p)
    reports.set(PlaceIndex{p}, !std::isnan(by_place[p]));
  nearest_.find(weighing_.network().places()[index(from)], most, reports, found_);
  Sum sum;
  for (const NearestGauges::Near& one : found_) {
    if (sum.is_full()) break;
    sum.add(neighbour(from, one.place, one.square).weight, by_place[index(one.place)]);
  }
  return sum.mean();
}

/// The places near one, of those that have reported so far. As gauges open one after the other, the
/// few that are new are put in their places.
const SurroundingRain::Neighbourhood& SurroundingRain::around(PlaceIndex place) {
  Neighbourhood& here = neighbourhoods_[index(place)];
  if (here.of == reporters_.size()) return here;
  if (reporters_.size() - here.of > kept) {
    find(place, here);
  } else {
    for (; here.of < reporters_.size(); ++here.of) insert(place, reporters_[here.of], here);
  }
  return here;
}

void SurroundingRain::find(PlaceIndex place, Neighbourhood& here) {
  nearest_.find(weighing_.network().places()[index(place)], here.wanted, have_reported_, found_);
  here.near.clear();
  for (const NearestGauges::Near& one : found_)
    here.near.push_back(neighbour(place, one.place, one.square));
  here.of = reporters_.size();
}

void SurroundingRain::insert(PlaceIndex place, PlaceIndex fresh, Neighbourhood& here) const {
  const Direction way = in_space_[index(fresh)] - in_space_[index(place)];
  const double square = dot(way, way);
  const std::vector<Point>& places = weighing_.network().places();
  const auto farther = std::find_if(here.near.begin(), here.near.end(), [&](const Neighbour& one) {
    return one.square != square ? one.square > square
                                : places[index(fresh)] < places[index(one.place)];
  });
  if (farther == here.near.end() && here.near.size() == here.wanted) return;
  here.near.insert(farther, neighbour(place, fresh, square));
  if (here.near.size() > here.wanted) here.near.pop_back();
}

SurroundingRain::Neighbour SurroundingRain::neighbour(PlaceIndex of, PlaceIndex place,
                                                      double square) const {
  constexpr double accuracy = 1e-3;  // metres
  if (square == 0) return {place, square, at_the_place};
  if (on_earth_.empty()) return {place, square, 1 / square};
  const double distance = arrival(on_earth_[index(place)], on_earth_[index(of)], accuracy).distance;
  return {place, square, 1 / (distance * distance)};
}

}  // namespace thiessen
