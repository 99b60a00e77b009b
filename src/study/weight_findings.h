#pragma once

#include <cstddef>
#include <vector>

#include "rainfall/network/weights.h"
#include "study/study.h"

namespace thiessen {

/// What the weights of a study show: which gauges stand in a basin, which weigh in none, and
/// whether the weights of each basin add up to 1.
struct WeightFindings {
  struct OfBasin {
    std::size_t gauges_inside = 0;  ///< those on its edge are inside
    double largest_weight = 0;
    double sum = 0;  ///< of its weights
    /// The sum is 1 within 1e-9, as it has to be: anything else is a fault of the library.
    bool adds_up() const;
  };
  std::vector<OfBasin> basins;
  std::size_t basins_without_gauge = 0;  ///< none stands inside
  std::size_t idle_gauges = 0;           ///< they weigh in no basin
};

/// Cost: linear in the weights; n log n in the gauges and in the basins' vertices.
WeightFindings findings_of(const Study& study, const std::vector<BasinWeights>& weights);

}  // namespace thiessen
