#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// Writes the weights by which the values of a series were computed, so that each can be computed
/// again: CSV `pattern,first_time,basin,station,weight`, and a last column `factor` where there are
/// normals; a block of rows for each set of reporting gauges (a pattern; where months have normals
/// of their own, for each set and month), with the time of the first step that has it. The value of
/// a basin at a step is the sum of weight x factor x reading over the rows of the step's pattern
/// and the basin. A basin without a value has no rows.
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
