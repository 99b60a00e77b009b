#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "rainfall/methods/area_method.h"

namespace thiessen {

/// What a place weighs at some points of a basin together.
struct PlaceSum {
  PlaceIndex place;
  double weight;
  double of_normals;  ///< the sum of weight x normal; 0 without normals
};

/// Adds up the weights of places at the points of a basin, for one basin after the other. Cost: the
/// number of places that weigh.
class WeightSums {
 public:
  explicit WeightSums(std::size_t places)
      : sum_(places, 0), of_normals_(places, 0), is_touched_(places, false) {}

  /// Adds what a place weighs at a point without a normal.
  void add(PlaceIndex place, double weight) {
    if (!is_touched_[index(place)]) {
      is_touched_[index(place)] = true;
      touched_.push_back(place);
    }
    sum_[index(place)] += weight;
  }
  /// Adds what a place weighs at a point that has this normal. Requires that all points of the
  /// basin have one, or none has.
  void add(PlaceIndex place, double weight, double normal) {
    add(place, weight);
    of_normals_[index(place)] += weight * normal;
    has_normals_ = true;
  }
  /// Adds what places weigh at several points.
  void add(std::span<const PlaceSum> sums) {
    for (const PlaceSum& sum : sums) {
      add(sum.place, sum.weight);
      of_normals_[index(sum.place)] += sum.of_normals;
      has_normals_ = has_normals_ || sum.of_normals > 0;
    }
  }

  /// Gives the sums as they are, in the order of the places, and begins anew.
  std::vector<PlaceSum> take_sums() {
    std::sort(touched_.begin(), touched_.end());
    std::vector<PlaceSum> sums;
    sums.reserve(touched_.size());
    for (const PlaceIndex p : touched_) sums.push_back({p, sum_[index(p)], of_normals_[index(p)]});
    begin_anew();
    return sums;
  }
  /// Gives the basin's weights, scaled to add up to 1, and begins the next basin. Weights of 1e-14
  /// and less are rounding and left out.
  std::vector<PlaceWeight> take() {
    constexpr double rounding = 1e-14;
    std::sort(touched_.begin(), touched_.end());
    double total = 0;
    for (const PlaceIndex p : touched_) total += sum_[index(p)];
    std::vector<PlaceWeight> weights;
    for (const PlaceIndex p : touched_) {
      const double weight = sum_[index(p)] / total;
      const double normal = has_normals_ ? of_normals_[index(p)] / sum_[index(p)] : 1;
      if (weight > rounding) weights.push_back({p, weight, normal});
    }
    begin_anew();
    return weights;
  }

 private:
  void begin_anew() {
    for (const PlaceIndex p : touched_) {
      sum_[index(p)] = 0;
      of_normals_[index(p)] = 0;
      is_touched_[index(p)] = false;
    }
    touched_.clear();
    has_normals_ = false;
  }

  std::vector<double> sum_;
  std::vector<double> of_normals_;  // the sums of weight x normal
  bool has_normals_ = false;
  std::vector<char> is_touched_;
  std::vector<PlaceIndex> touched_;
};

}  // namespace thiessen
