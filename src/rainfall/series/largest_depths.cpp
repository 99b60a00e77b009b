#include "rainfall/series/largest_depths.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "rainfall/series/dated_readings.h"
#include "rainfall/series/step_depths.h"

namespace thiessen {
namespace {

/// Where nine in ten intervals are multiples of one, that is among the first few.
constexpr std::size_t most_paces = 16;

/// A length as the option takes it: 3h, 90min, 2d.
std::string short_text(std::int64_t seconds) {
  if (seconds % 3'600 == 0) return std::to_string(seconds / 3'600) + "h";
  return std::to_string(seconds / 60) + "min";
}

}  // namespace

LargestDepths::LargestDepths(std::vector<std::int64_t> lengths, std::size_t basins,
                             std::string file)
    : lengths_(std::move(lengths)), basins_(basins), file_(std::move(file)) {
  for (const std::int64_t length : lengths_) single_.push_back(window_of(length, length));
}

/// The window of a length where steps are as long as an interval.
LargestDepths::Window LargestDepths::window_of(std::int64_t length, std::int64_t interval) const {
  Window window;
  if (length % interval != 0) return window;
  window.steps = static_cast<std::size_t>(length / interval);
  window.sums.resize(basins_);
  window.missing.resize(basins_);
  window.largest.resize(basins_);
  return window;
}

void LargestDepths::add(const RainStep& step) {
  const IsoTime time = time_of_step(step.time, TimePrecision::year, file_, step.line, step.written);
  const std::int64_t since = way_from_before(step, time);
  intervals_.note({time, IsoTimeFault::none});
  Step added{moment_seconds(time), step.time, {}};
  for (const BasinRainfall& basin : step.basins) added.values.push_back(basin.rainfall);
  steps_.push_back(std::move(added));
  const std::int64_t longest = *std::max_element(lengths_.begin(), lengths_.end());
  while (std::abs(steps_.back().moment - steps_.front().moment) > longest && steps_.size() > 2) {
    steps_.pop_front();
    ++first_;
  }
  for (Window& window : single_) {
    for (std::size_t b = 0; b < basins_; ++b) {
      const double value = steps_.back().values[b];
      if (!std::isnan(value)) note(window.largest[b], value, steps_.back().time);
    }
  }
  if (since == 0) return;
  auto pace = paces_.find(since);
  if (pace == paces_.end()) {
    const bool fits = std::ranges::any_of(
        lengths_, [&](std::int64_t length) { return length > since && length % since == 0; });
    if (!fits || paces_.size() == most_paces) return;
    pace = paces_.try_emplace(since).first;
    for (const std::int64_t length : lengths_)
      pace->second.windows.push_back(window_of(length, since));
  }
  go_on(pace->second);
}

/// The seconds since the step before, either way; 0 of the first. Throws Error where times turn.
std::int64_t LargestDepths::way_from_before(const RainStep& step, const IsoTime& time) {
  if (steps_.empty()) return 0;
  const std::int64_t since = moment_seconds(time) - steps_.back().moment;
  const std::int64_t way = since > 0 ? 1 : -1;
  if (since != 0 && (way_ == 0 || way_ == way)) {
    way_ = way;
    return std::abs(since);
  }
  throw Error({file_, step.line,
               "time " + quoted(step.time, 80) +
                   (since == 0 ? " is that of the step before" : " turns back") +
                   ", and the largest depths want times in their order",
               "sort the file by time"});
}

/// Takes the latest step, which comes at a pace of its own interval.
void LargestDepths::go_on(Pace& pace) {
  const std::size_t latest = first_ + steps_.size() - 1;
  if (pace.run == 0 || pace.last + 1 != latest) {
    pace.run = 0;
    for (Window& window : pace.windows) {
      std::fill(window.sums.begin(), window.sums.end(), LongSum());
      std::fill(window.missing.begin(), window.missing.end(), 0);
    }
    take(pace, latest - 1);
  }
  take(pace, latest);
}

void LargestDepths::take(Pace& pace, std::size_t number) {
  pace.last = number;
  ++pace.run;
  for (Window& window : pace.windows) {
    if (window.steps < 2) continue;
    const bool is_full = pace.run >= window.steps;
    const Step* const left = pace.run > window.steps ? &step(number - window.steps) : nullptr;
    // Where times descend the earliest step of a window is the one that was read last.
    const Step& begins = step(is_full && way_ > 0 ? number + 1 - window.steps : number);
    for (std::size_t b = 0; b < basins_; ++b) {
      const double value = step(number).values[b];
      if (std::isnan(value)) {
        ++window.missing[b];
      } else {
        window.sums[b].add(value);
      }
      if (left != nullptr) {
        if (std::isnan(left->values[b])) {
          --window.missing[b];
        } else {
          window.sums[b].add(-left->values[b]);
        }
      }
      if (is_full && window.missing[b] == 0)
        note(window.largest[b], window.sums[b].value(), begins.time);
    }
  }
}

void LargestDepths::note(std::optional<LargestDepth>& largest, double depth,
                         const std::string& time) const {
  if (largest && (depth < largest->depth || (depth == largest->depth && way_ >= 0))) return;
  largest = {depth, time};
}

std::vector<std::vector<std::optional<LargestDepth>>> LargestDepths::result(
    const std::optional<StepLength>& rate) const {
  const std::optional<StepLength> step = intervals_.step();
  if (!step) {
    throw Error(
        {file_, 0,
         std::string("the largest depths want a step, and ") +
             (intervals_.times() < 2 ? "one time tells none" : "the times have no regular step"),
         "leave " + setting("max") + " out"});
  }
  std::vector<std::vector<std::optional<LargestDepth>>> result;
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    if (step->months > 0 || lengths_[i] % step->seconds != 0) {
      const bool has_next = step->months == 0 && step->seconds % 60 == 0;
      const std::int64_t next = has_next ? (lengths_[i] / step->seconds + 1) * step->seconds : 0;
      throw Error({file_, 0,
                   short_text(lengths_[i]) + " are no whole steps of the file, which are of " +
                       text_of(*step),
                   has_next ? setting("max", short_text(next)) + " is"
                            : "leave " + setting("max") + " out"});
    }
    const auto pace = paces_.find(step->seconds);
    if (lengths_[i] == step->seconds) {
      result.push_back(single_[i].largest);
    } else if (pace != paces_.end()) {
      result.push_back(pace->second.windows[i].largest);
    } else {
      result.emplace_back(basins_);
    }
  }
  if (!rate || *rate == *step) return result;
  if (rate->months > 0) {
    throw Error({file_, 0,
                 "the readings are rates by the " + text_of(*rate) +
                     ", whose depth in hours is another in each month",
                 "leave " + setting("max") + " out"});
  }
  const double depth = static_cast<double>(step->seconds) / static_cast<double>(rate->seconds);
  for (auto& of_length : result) {
    for (auto& of_basin : of_length) {
      if (of_basin) of_basin->depth *= depth;
    }
  }
  return result;
}

}  // namespace thiessen
