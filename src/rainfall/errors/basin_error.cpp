#include "rainfall/errors/basin_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thiessen {
namespace {

/// The mean distance between two points of a square, as a share of its side (E. Borel, 1924).
constexpr double mean_distance_in_square = 0.521405433164721;

/// How many gauges are remembered that weigh only where others are silent: this bounds the memory.
constexpr std::size_t remembered = 4096;

}  // namespace

BasinError::BasinError(std::vector<SiteWeight> full, std::vector<Direction> points,
                       double side_of_point, const Sites& sites, const Variogram& variogram)
    : sites_(sites),
      variogram_(variogram),
      full_(std::move(full)),
      points_(std::make_shared<const std::vector<Direction>>(std::move(points))) {
  terms_.reserve(full_.size());
  for (const SiteWeight& w : full_) terms_.push_back(terms_of(w.site));
  sum_up();
  points_points_ = within_points(side_of_point);
}

BasinError::BasinError(const BasinError& like, std::vector<SiteWeight> full)
    : sites_(like.sites_),
      variogram_(like.variogram_),
      full_(std::move(full)),
      points_(like.points_),
      points_points_(like.points_points_) {
  terms_.reserve(full_.size());
  auto known = like.full_.begin();
  for (const SiteWeight& w : full_) {
    while (known != like.full_.end() && known->site < w.site) ++known;
    const bool is_known = known != like.full_.end() && known->site == w.site;
    const auto number = static_cast<std::size_t>(known - like.full_.begin());
    terms_.push_back(
        {with_weights(w.site), is_known ? like.terms_[number].with_points : with_points(w.site)});
  }
  sum_up();
}

void BasinError::sum_up() {
  for (std::size_t i = 0; i < full_.size(); ++i) {
    weights_weights_ += full_[i].weight * terms_[i].with_weights;
    weights_points_ += full_[i].weight * terms_[i].with_points;
  }
}

double BasinError::within_points(double side_of_point) const {
  const std::vector<Direction>& points = *points_;
  const double own = side_of_point * mean_distance_in_square;
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) sum += variogram_(points[i], points[j]);
  }
  const auto count = static_cast<double>(points.size());
  return (2 * sum / count + variogram_.at_square(own * own)) / count;
}

BasinError::Terms BasinError::terms_of(std::uint32_t site) const {
  return {with_weights(site), with_points(site)};
}

double BasinError::with_weights(std::uint32_t site) const {
  const Direction at = sites_[site];
  double sum = 0;
  for (const SiteWeight& w : full_) {
    if (w.site != site) sum += w.weight * variogram_(at, sites_[w.site]);
  }
  return sum;
}

double BasinError::with_points(std::uint32_t site) const {
  const Direction at = sites_[site];
  double sum = 0;
  for (const Direction& point : *points_) sum += variogram_(at, point);
  return sum / static_cast<double>(points_->size());
}

std::vector<BasinError::Terms> BasinError::terms_of(std::span<const SiteWeight> change) const {
  std::vector<Terms> terms;
  terms.reserve(change.size());
  const std::lock_guard lock(mutex_);
  auto own = full_.begin();
  for (const SiteWeight& c : change) {
    own = std::lower_bound(own, full_.end(), c.site,
                           [](const SiteWeight& w, std::uint32_t site) { return w.site < site; });
    if (own != full_.end() && own->site == c.site) {
      terms.push_back(terms_[static_cast<std::size_t>(own - full_.begin())]);
    } else if (const auto known = others_.find(c.site); known != others_.end()) {
      terms.push_back(known->second);
    } else {
      terms.push_back(terms_of(c.site));
      if (others_.size() < remembered) others_.emplace(c.site, terms.back());
    }
  }
  return terms;
}

double BasinError::mean_square(std::span<const SiteWeight> change) const {
  double weights = weights_weights_;
  double points = weights_points_;
  double sum = 1;
  if (!change.empty()) {
    const std::vector<Terms> terms = terms_of(change);
    for (std::size_t i = 0; i < change.size(); ++i) {
      double among = 0;
      const Direction at = sites_[change[i].site];
      for (std::size_t j = i + 1; j < change.size(); ++j)
        among += change[j].weight * variogram_(at, sites_[change[j].site]);
      weights += 2 * change[i].weight * (terms[i].with_weights + among);
      points += change[i].weight * terms[i].with_points;
      sum += change[i].weight;
    }
  }
  return std::max(0.0, 2 * points / sum - weights / (sum * sum) - points_points_);
}

}  // namespace thiessen
