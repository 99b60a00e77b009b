#include "rainfall/leaving_out/left_out_weights.h"

#include <algorithm>
#include <cstdint>

#include "rainfall/methods/linear_weights.h"

namespace thiessen {
namespace {

std::size_t hash_of(std::span<const PlaceIndex> places) {
  std::uint64_t hash = 0x9E3779B97F4A7C15;
  for (const PlaceIndex p : places) {
    hash = (hash ^ index(p)) * 0xBF58476D1CE4E5B9;
    hash ^= hash >> 31U;
  }
  return static_cast<std::size_t>(hash);
}

/// Gives the weights of a tessellation's gauges to the places that have their numbers, in equal
/// shares where rounding cannot tell these apart, scaled to add up to 1.
std::vector<PointWeight> by_places(std::span<const NaturalWeight> weights,
                                   std::span<const PointId> numbers,
                                   std::span<const PlaceIndex> places) {
  double total = 0;
  for (const NaturalWeight& w : weights) total += w.weight;
  std::vector<PointWeight> shares;
  for (const NaturalWeight& w : weights) {
    if (!(w.weight > 0)) continue;
    const auto count = std::count(numbers.begin(), numbers.end(), w.gauge);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i] == w.gauge)
        shares.push_back({places[i], w.weight / total / static_cast<double>(count)});
    }
  }
  return shares;
}

}  // namespace

LeftOutWeighing::LeftOutWeighing(std::span<const Point> places, Metric metric)
    : neighbours_(places, metric), remembered_(places.size()) {}

const LeftOutWeights& LeftOutWeighing::at(PlaceIndex place) {
  neighbours_.find(place, found_);
  if (count_ > most_remembered) {
    for (auto& of_place : remembered_) of_place.clear();
    count_ = 0;
  }
  auto& with_hash = remembered_[index(place)][hash_of(found_)];
  for (const Remembered& known : with_hash) {
    if (known.neighbours == found_) return known.weights;
  }
  with_hash.push_back({found_, {}});
  LeftOutWeights& weights = with_hash.back().weights;
  weigh(place, weights);
  count_ += found_.size() + weights.natural.size() + weights.linear.size();
  return weights;
}

void LeftOutWeighing::weigh(PlaceIndex place, LeftOutWeights& weights) {
  if (found_.empty()) return;
  ChartPoint own;
  neighbours_.chart(place, found_, points_, own);
  NaturalWeights gauges(points_, neighbours_.kind());
  if (!gauges.find(own, weights_)) return;
  weights.natural = by_places(weights_, gauges.numbers(), found_);
  weights.linear = weights.natural;
  const Tessellation<2>& triangles = gauges.tessellation();
  if (triangles.span() != Span::plane || !in_exact_range(own.at)) return;
  const VertexId v = triangles.locate(own.at);
  if (triangles.topology().is_infinite(v)) {
    weights.linear.clear();
  } else {
    weights.linear = by_places(linear_weights(gauges, v, own), gauges.numbers(), found_);
  }
}

}  // namespace thiessen
