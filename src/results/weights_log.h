#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "rainfall/weights.h"

namespace thiessen {

/// The account of a series: with what weights its values were had. CSV
/// `pattern,first_time,basin,station,weight`, a block for each set of reporting gauges, at the time
/// of its first step: a value is the sum of weight x reading over the rows of its step's pattern
/// and its basin. A basin without a value has no rows.
class WeightsLog {
 public:
  /// Writes the header. The file and the weighing must outlive it.
  WeightsLog(OutputFile& file, const Weighing& weighing);
  void add(std::size_t pattern, std::string_view first_time,
           const std::vector<BasinWeights>& weights);

 private:
  OutputFile& file_;
  const Weighing& weighing_;
};

}  // namespace thiessen
