#include "rainfall/series/rain_series.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "base/interrupt.h"
#include "base/parallel.h"

namespace thiessen {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto worth_telling = std::chrono::milliseconds(150);
constexpr std::chrono::milliseconds longest_wait(200);
constexpr std::size_t block_bytes = std::size_t{16} << 20;

/// A block of steps, whose memory is used again for the next block.
class Block {
 public:
  std::size_t count() const { return count_; }
  RainStep& operator[](std::size_t i) { return steps_[i]; }
  void clear() { count_ = 0; }
  void add(const TimeStep& step) {
    if (count_ == steps_.size()) steps_.emplace_back();
    RainStep& added = steps_[count_++];
    added.time = step.time;
    added.written = step.written;
    added.readings.assign(step.readings.begin(), step.readings.end());
    added.text.clear();
    added.line = step.line;
  }
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

/// Reads blocks of steps. Those of a pipe that are wanted as they come end where no step has come.
class BlockReader {
 public:
  BlockReader(Readings& readings, bool is_fed) : readings_(readings), is_fed_(is_fed) {}

  bool is_at_end() const { return is_at_end_; }
  void read(Block& block, std::size_t most) {
    block.clear();
    try {
      while (!is_at_end_ && block.count() < most) {
        if (is_fed_ && readings_.is_waiting(std::chrono::milliseconds(0))) return;
        is_at_end_ = !readings_.next(step_);
        if (!is_at_end_) block.add(step_);
      }
    } catch (...) {
      if (!is_fed_) throw;
      failure_ = std::current_exception();
      is_at_end_ = true;
    }
  }
  /// Waits for a step, or the end.
  void wait(const std::function<void()>& when_handed_on) {
    do {
      throw_if_interrupted();
      when_handed_on();
    } while (readings_.is_waiting(longest_wait));
  }
  bool has_failed() const { return failure_ != nullptr; }
  void throw_failure() {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  Readings& readings_;
  bool is_fed_;
  bool is_at_end_ = false;
  std::exception_ptr failure_;
  TimeStep step_;
};

}  // namespace

const StepRainfall& rainfall_at(const StepRainfall& rainfall, const RainStep& step,
                                const SeriesWork& work) {
  return rainfall.tells_months() ? rainfall.in_month(work.month_of(step)) : rainfall;
}

std::size_t for_each_step(Readings& readings, const StepRainfall& rainfall, const SeriesWork& work,
                          const std::function<void(RainStep&)>& prepare,
                          const std::function<void(const RainStep&)>& take) {
  Block block;
  Block ahead;
  BlockReader reader(readings, static_cast<bool>(work.when_handed_on));
  // Small blocks let slow steps be handed on soon; in large ones threads wait less for each other.
  // So blocks grow as long as they take no time worth telling.
  std::size_t most = std::min(std::size_t{2} * std::max(1u, work.threads), work.steps_in_a_block);
  const auto compute = [&] {
    const auto begin = Clock::now();
    in_parallel(block.count(), work.threads, [&](std::size_t, std::size_t i) {
      block[i].basins = rainfall_at(rainfall, block[i], work).at(block[i].readings);
      prepare(block[i]);
    });
    if (Clock::now() - begin >= worth_telling) return;
    most =
        std::max<std::size_t>(1, std::min({2 * most, work.steps_in_a_block, block.affordable()}));
  };
  std::size_t count = 0;
  auto called = Clock::now();
  for (reader.read(block, most);; std::swap(block, ahead)) {
    if (block.count() == 0) {
      if (reader.is_at_end()) break;
      reader.wait(work.when_handed_on);
      called = Clock::now();
      reader.read(ahead, most);
      continue;
    }
    if (work.threads > 1) {
      const std::size_t most_ahead = most;
      side_by_side(compute, [&] { reader.read(ahead, most_ahead); });
    } else {
      compute();
    }
    for (std::size_t i = 0; i < block.count(); ++i) take(block[i]);
    count += block.count();
    if (work.when_handed_on && Clock::now() - called >= longest_wait) {
      work.when_handed_on();
      called = Clock::now();
    }
    if (work.threads == 1) reader.read(ahead, most);
  }
  if (reader.has_failed()) work.when_handed_on();
  reader.throw_failure();
  return count;
}

}  // namespace thiessen
