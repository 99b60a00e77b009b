#include "rainfall/series/rain_series.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <utility>

#include "base/parallel.h"

namespace thiessen {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto worth_telling = std::chrono::milliseconds(150);
constexpr std::size_t block_bytes = std::size_t{16} << 20;

/// A block of steps, whose memory is used again for the next block.
class Block {
 public:
  void read(Readings& readings, std::size_t most) {
    TimeStep step;
    for (count_ = 0; count_ < most && readings.next(step); ++count_) {
      if (count_ == steps_.size()) steps_.emplace_back();
      steps_[count_].time = step.time;
      steps_[count_].written = step.written;
      steps_[count_].readings.assign(step.readings.begin(), step.readings.end());
      steps_[count_].text.clear();
      steps_[count_].line = step.line;
    }
  }
  std::size_t count() const { return count_; }
  RainStep& operator[](std::size_t i) { return steps_[i]; }
  /// How many steps of the first one's size a block may hold. Requires that the first is computed.
  std::size_t affordable() const {
    const RainStep& step = steps_.front();
    const std::size_t bytes = sizeof step + step.readings.size() * sizeof(double) +
                              step.basins.size() * sizeof(BasinRainfall) + step.text.size();
    return block_bytes / bytes;
  }

 private:
  std::vector<RainStep> steps_;
  std::size_t count_ = 0;
};

}  // namespace

std::size_t for_each_step(Readings& readings, const StepRainfall& rainfall, const SeriesWork& work,
                          const std::function<void(RainStep&)>& prepare,
                          const std::function<void(const RainStep&)>& take) {
  Block block;
  Block ahead;
  // Small blocks let slow steps be handed on soon; in large ones threads wait less for each other.
  // So blocks grow as long as they take no time worth telling.
  std::size_t most = std::min(std::size_t{2} * std::max(1u, work.threads), work.steps_in_a_block);
  const auto compute = [&] {
    const auto begin = Clock::now();
    in_parallel(block.count(), work.threads, [&](std::size_t, std::size_t i) {
      block[i].basins = rainfall.at(block[i].readings);
      prepare(block[i]);
    });
    if (Clock::now() - begin >= worth_telling) return;
    most =
        std::max<std::size_t>(1, std::min({2 * most, work.steps_in_a_block, block.affordable()}));
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
