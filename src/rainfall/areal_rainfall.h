#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include "rainfall/weights.h"

namespace thiessen {

/// What a time step with silent gauges gets.
enum class Gaps {
  retessellate,  ///< the tessellation of the gauges that report
  renormalise,   ///< the full network's weights, scaled to the gauges that report
  strict         ///< no value, where any gauge of positive weight is silent
};

/// The areal rainfall of one basin at one time.
struct BasinRainfall {
  double rainfall;  ///< sum of weight x reading, in the readings' unit; NaN where it cannot be had
  std::size_t gauges;  ///< that weigh in the value
  double coverage;     ///< share of the basin that the full network gives to gauges that report
};

/// Turns readings into areal rainfall. Safe for several threads at once. Weights of a set of
/// reporting gauges are remembered as long as they fit into `remembered_bytes`, the sets seen
/// first. Cost of a step: its gauges and the weights; for a new set of reporting gauges also
/// Weighing::weights.
class ArealRainfall {
 public:
  static constexpr std::size_t usual_memory = std::size_t{256} << 20;

  ArealRainfall(const Weighing& weighing, Gaps gaps, std::size_t min_gauges,
                std::size_t remembered_bytes = usual_memory, unsigned threads = 1);

  /// The full network's weights.
  const std::vector<BasinWeights>& full_weights() const { return full_; }

  /// By basin. `readings`: one a station, NaN where it is silent.
  std::vector<BasinRainfall> at(std::span<const double> readings) const;

 private:
  using Weights = std::shared_ptr<const std::vector<BasinWeights>>;
  struct BitsHash {
    std::size_t operator()(const std::vector<bool>& bits) const {
      return std::hash<std::vector<bool>>{}(bits);
    }
  };

  Weights weights_of(const std::vector<bool>& reports) const;
  BasinRainfall retessellated(const BasinWeights& weights, std::span<const double> readings) const;
  BasinRainfall from_full_network(const BasinWeights& weights,
                                  std::span<const double> readings) const;

  const Weighing& weighing_;
  Gaps gaps_;
  std::size_t min_gauges_;
  std::size_t remembered_bytes_;
  std::vector<BasinWeights> full_;
  mutable std::mutex mutex_;
  mutable std::size_t bytes_ = 0;
  mutable std::unordered_map<std::vector<bool>, Weights, BitsHash> remembered_;
};

}  // namespace thiessen
