#pragma once

#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

#include "rainfall/leaving_out/reporting_neighbours.h"
#include "rainfall/methods/natural_weights.h"

namespace thiessen {

/// What a place weighs at a point.
struct PointWeight {
  PlaceIndex place;
  double weight;
};

/// What the other places that report weigh at a place by natural neighbours and linearly in
/// triangles, as NaturalSurface and LinearSurface have them there without the place. Both lists are
/// empty where it lies beyond the hull of the others, and the nearest tells.
struct LeftOutWeights {
  std::vector<PointWeight> natural;
  std::vector<PointWeight> linear;
};

/// Finds these weights by the tessellation of a place's neighbours alone, and remembers them by the
/// place and its neighbours, for sets of reporting gauges come in spells. Memory: that of
/// `most_remembered` weights; when there are more, all are forgotten. Cost: a look at a place's
/// neighbours, 0.2 microseconds; 5 to 10 for new neighbours.
class LeftOutWeighing {
 public:
  LeftOutWeighing(std::span<const Point> places, Metric metric);

  void report(const ReportingPlaces& reports) { neighbours_.report(reports); }
  /// The weights at a place that reports, valid until the next call.
  const LeftOutWeights& at(PlaceIndex place);

 private:
  static constexpr std::size_t most_remembered = 2'000'000;

  struct Remembered {
    std::vector<PlaceIndex> neighbours;
    LeftOutWeights weights;
  };
  void weigh(PlaceIndex place, LeftOutWeights& weights);

  ReportingNeighbours neighbours_;
  std::vector<std::unordered_map<std::size_t, std::vector<Remembered>>> remembered_;  // by place
  std::size_t count_ = 0;  // of remembered weights and neighbours
  std::vector<PlaceIndex> found_;
  std::vector<ChartPoint> points_;
  std::vector<NaturalWeight> weights_;
};

}  // namespace thiessen
