#include "rainfall/leaving_out/left_out_estimates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "basin/containment.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/methods/arithmetic_mean.h"
#include "rainfall/methods/inverse_distance.h"
#include "rainfall/methods/rain_surface.h"

namespace thiessen {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kept_at_most = 40;

/// By place: the first basin that holds it, or the number of basins.
std::vector<std::size_t> first_basins(const std::vector<Basin>& basins,
                                      const std::vector<Point>& places, Metric metric) {
  std::vector<std::size_t> first(places.size(), basins.size());
  const auto inside = points_within(basins, places, metric == Metric::geodesic ? 360 : 0);
  for (std::size_t b = basins.size(); b-- > 0;) {
    for (const std::size_t p : inside[b]) first[p] = b;
  }
  return first;
}

}  // namespace

const char* name_of(PointMethod method) {
  switch (method) {
    case PointMethod::thiessen:
      return ArealRainfall::name;
    case PointMethod::arithmetic:
      return ArithmeticMean::name;
    case PointMethod::idw:
      return name_of(SurfaceMethod::idw);
    case PointMethod::natural:
      return name_of(SurfaceMethod::natural);
    case PointMethod::linear:
      return name_of(SurfaceMethod::linear);
  }
  throw std::logic_error("not a method");
}

LeftOutEstimates::LeftOutEstimates(const Network& network, Metric metric,
                                   const std::vector<Basin>& basins)
    : network_(network),
      nearest_(network.places(), metric),
      distances_(network.places(), metric),
      kept_(std::min(kept_at_most, network.places().size() - 1)),
      group_of_(first_basins(basins, network.places(), metric)),
      groups_(basins.size()),
      weighing_(network.places(), metric),
      reports_(network.places().size(), false) {
  keep_nearest(network.places());
}

void LeftOutEstimates::keep_nearest(const std::vector<Point>& places) {
  near_.reserve(kept_ * places.size());
  for (std::uint32_t p = 0; p < places.size(); ++p) {
    nearest_.find(places[p], kept_ + 1, {}, searched_);
    std::erase_if(searched_, [&](const auto& near) { return near.place == PlaceIndex{p}; });
    searched_.resize(kept_);
    distances_.from(places[p], searched_, squares_);
    for (std::size_t i = 0; i < kept_; ++i) near_.push_back({searched_[i].place, squares_[i]});
  }
}

void LeftOutEstimates::report(const ReportingPlaces& reports) {
  if (reports == reports_) return;
  reports_ = reports;
  is_tessellated_ = false;
}

void LeftOutEstimates::tessellate() {
  if (is_tessellated_) return;
  weighing_.report(reports_);
  for (std::uint32_t p = 0; p < reports_.size(); ++p) {
    if (reports_[PlaceIndex{p}]) weighing_.at(PlaceIndex{p});
  }
  is_tessellated_ = true;
}

/// Finds up to so many of the nearest other places that report.
void LeftOutEstimates::find_reporting(std::size_t place, std::size_t count) {
  found_.clear();
  for (const Near& near : kept_at(place)) {
    if (!reports_[near.place]) continue;
    found_.push_back(near);
    if (found_.size() == count) return;
  }
  if (kept_ + 1 == reports_.size()) return;
  ReportingPlaces others = reports_;
  others.set(PlaceIndex{static_cast<std::uint32_t>(place)}, false);
  const Point at = network_.places()[place];
  nearest_.find(at, count, others, searched_);
  distances_.from(at, searched_, squares_);
  found_.clear();
  for (std::size_t i = 0; i < searched_.size(); ++i)
    found_.push_back({searched_[i].place, squares_[i]});
}

double LeftOutEstimates::nearest_value(std::size_t place, std::span<const double> values) {
  find_reporting(place, 1);
  return found_.empty() ? nothing : values[index(found_.front().place)];
}

double LeftOutEstimates::idw_value(std::size_t place, std::span<const double> values) {
  find_reporting(place, InverseDistance::neighbours);
  double sum = 0;
  double total = 0;
  for (const Near& near : found_) {
    if (near.square == 0) return values[index(near.place)];
    const double weight = found_.front().square / near.square;
    sum += weight * values[index(near.place)];
    total += weight;
  }
  return found_.empty() ? nothing : sum / total;
}

double LeftOutEstimates::tessellated_value(PointMethod method, std::size_t place,
                                           std::span<const double> values) {
  const LeftOutWeights& weights = weighing_.at(PlaceIndex{static_cast<std::uint32_t>(place)});
  const auto& of_method = method == PointMethod::natural ? weights.natural : weights.linear;
  if (of_method.empty()) return nearest_value(place, values);
  double sum = 0;
  for (const PointWeight& w : of_method) sum += w.weight * values[index(w.place)];
  return sum;
}

void LeftOutEstimates::tell_means(std::span<const double> values, std::span<double> told) const {
  struct Mean {
    double sum = 0;
    std::size_t count = 0;
    double without(double value) const {
      return count > 1 ? (sum - value) / static_cast<double>(count - 1) : nothing;
    }
  };
  // Sums are of what is above the least value, so that nothing is lost where all are equal.
  std::vector<Mean> groups(groups_ + 1);
  Mean all;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t p = 0; p < values.size(); ++p) {
    if (reports_[PlaceIndex{p}]) least = std::min(least, values[p]);
  }
  for (std::uint32_t p = 0; p < values.size(); ++p) {
    if (!reports_[PlaceIndex{p}]) continue;
    for (Mean* mean : {&groups[group_of_[p]], &all}) {
      mean->sum += values[p] - least;
      ++mean->count;
    }
  }
  for (std::uint32_t p = 0; p < values.size(); ++p) {
    if (!reports_[PlaceIndex{p}]) continue;
    const bool has_group = group_of_[p] != groups_ && groups[group_of_[p]].count > 1;
    told[p] = least + (has_group ? groups[group_of_[p]] : all).without(values[p] - least);
  }
}

void LeftOutEstimates::tell(PointMethod method, std::span<const double> values,
                            std::span<double> told) {
  if (method == PointMethod::arithmetic) return tell_means(values, told);
  if (method == PointMethod::natural || method == PointMethod::linear) tessellate();
  for (std::uint32_t p = 0; p < values.size(); ++p) {
    if (!reports_[PlaceIndex{p}]) continue;
    if (method == PointMethod::thiessen) {
      told[p] = nearest_value(p, values);
    } else if (method == PointMethod::idw) {
      told[p] = idw_value(p, values);
    } else {
      told[p] = tessellated_value(method, p, values);
    }
  }
}

}  // namespace thiessen
