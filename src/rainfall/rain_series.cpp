#include "rainfall/rain_series.h"

#include "base/parallel.h"

namespace thiessen {

std::size_t for_each_step(Readings& readings, const ArealRainfall& rainfall, unsigned threads,
                          const std::function<void(const RainStep&)>& take) {
  constexpr std::size_t block_size = 256;
  std::size_t count = 0;
  std::vector<RainStep> block;
  for (bool more = true; more;) {
    block.clear();
    TimeStep step;
    while (block.size() < block_size && (more = readings.next(step))) {
      block.push_back({step.time, {step.readings.begin(), step.readings.end()}, {}});
    }
    in_parallel(block.size(), threads, [&](std::size_t, std::size_t i) {
      block[i].basins = rainfall.at(block[i].readings);
    });
    for (const RainStep& done : block) take(done);
    count += block.size();
  }
  return count;
}

}  // namespace thiessen
