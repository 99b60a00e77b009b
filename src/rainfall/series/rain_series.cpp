#include "rainfall/series/rain_series.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <utility>

#include "base/parallel.h"

namespace thiessen {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto worth_telling = std::chrono::milliseconds(50);

/// Some steps, whose memory is used again.
class Block {
 public:
  explicit Block(std::size_t most) : steps_(most) {}

  void read(Readings& readings, std::size_t most) {
    TimeStep step;
    for (count_ = 0; count_ < std::min(most, steps_.size()) && readings.next(step); ++count_) {
      steps_[count_].time = step.time;
      steps_[count_].readings.assign(step.readings.begin(), step.readings.end());
      steps_[count_].text.clear();
      steps_[count_].line = step.line;
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
  // Blocks grow as long as they take no time worth telling, so that slow steps are told soon.
  std::size_t most = std::size_t{2} * std::max(1u, work.threads);
  const auto compute = [&] {
    const auto begin = Clock::now();
    in_parallel(block.count(), work.threads, [&](std::size_t, std::size_t i) {
      block[i].basins = rainfall.at(block[i].readings);
      prepare(block[i]);
    });
    if (Clock::now() - begin < worth_telling) most = std::min(2 * most, work.steps_in_a_block);
  };
  std::size_t count = 0;
  for (block.read(readings, most); block.count() > 0; std::swap(block, ahead)) {
    if (work.threads > 1) {
      const std::size_t most_ahead = most;
      auto computing = std::async(std::launch::async, compute);
      ahead.read(readings, most_ahead);
      computing.get();
    } else {
      compute();
    }
    for (std::size_t i = 0; i < block.count(); ++i) take(block[i]);
    count += block.count();
    if (work.threads == 1) ahead.read(readings, most);
  }
  return count;
}

}  // namespace thiessen
