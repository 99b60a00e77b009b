#include "rainfall/rain_series.h"

#include <future>
#include <utility>

#include "base/parallel.h"

namespace thiessen {
namespace {

/// Some steps, whose memory is used again.
class Block {
 public:
  explicit Block(std::size_t most) : steps_(most) {}

  void read(Readings& readings) {
    TimeStep step;
    for (count_ = 0; count_ < steps_.size() && readings.next(step); ++count_) {
      steps_[count_].time = step.time;
      steps_[count_].readings.assign(step.readings.begin(), step.readings.end());
      steps_[count_].text.clear();
    }
  }
  std::size_t count() const { return count_; }
  RainStep& operator[](std::size_t i) { return steps_[i]; }

 private:
  std::vector<RainStep> steps_;
  std::size_t count_ = 0;
};

}  // namespace

std::size_t for_each_step(Readings& readings, const StepRainfall& rainfall, const SeriesWork& work,
                          const std::function<void(RainStep&)>& prepare,
                          const std::function<void(const RainStep&)>& take) {
  Block block(work.steps_in_a_block);
  Block ahead(work.steps_in_a_block);
  const auto compute = [&] {
    in_parallel(block.count(), work.threads, [&](std::size_t, std::size_t i) {
      block[i].basins = rainfall.at(block[i].readings);
      prepare(block[i]);
    });
  };
  std::size_t count = 0;
  for (block.read(readings); block.count() > 0; std::swap(block, ahead)) {
    if (work.threads > 1) {
      auto computing = std::async(std::launch::async, compute);
      ahead.read(readings);
      computing.get();
    } else {
      compute();
    }
    for (std::size_t i = 0; i < block.count(); ++i) take(block[i]);
    count += block.count();
    if (work.threads == 1) ahead.read(readings);
  }
  return count;
}

}  // namespace thiessen
