#include "readings/steps/counter_readings.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t longest_time = 80;
constexpr std::size_t steps_ahead = 16;
constexpr std::chrono::milliseconds at_once(0);

std::string others(std::size_t count) {
  return count == 1 ? "" : ", the first of " + std::to_string(count);
}

}  // namespace

CounterReadings::CounterReadings(std::unique_ptr<Readings> all, std::string file,
                                 std::span<const Station> stations, Warnings& warnings)
    : all_(std::move(all)),
      file_(std::move(file)),
      stations_(stations),
      warnings_(warnings),
      counters_(stations.size(), {none, false}),
      amounts_(stations.size(), none) {}

bool CounterReadings::next(TimeStep& step) {
  if (!std::exchange(has_read_ahead_, true)) read_ahead();
  if (!take(step)) {
    conclude();
    return false;
  }
  forget_steps_before_a_gap(step);
  require_order(step);
  for (std::size_t i = 0; i < amounts_.size(); ++i) {
    const double reading = step.readings[i];
    const bool reports = !std::isnan(reading);
    amounts_[i] = reports ? rain_of(i, reading, step) : none;
    if (reports) counters_[i].last = reading;
    counters_[i].is_of_last_step = reports;
  }
  step.readings = amounts_;
  return true;
}

/// Reads the first steps, of a pipe those that are there.
void CounterReadings::read_ahead() {
  try {
    TimeStep step;
    while (ahead_.size() < steps_ahead && (ahead_.empty() || !all_->is_waiting(at_once)) &&
           read(step)) {
      ahead_.push_back({step, {step.readings.begin(), step.readings.end()}});
    }
  } catch (...) {
    failure_ = std::current_exception();
  }
}

bool CounterReadings::read(TimeStep& step) {
  if (!all_->next(step)) return false;
  if (const ParsedTime time = calendar_time(step.time, step.written)) usual_step_.note(time.time);
  return true;
}

/// Takes the next step, read ahead or not.
bool CounterReadings::take(TimeStep& step) {
  if (ahead_.empty()) {
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return read(step);
  }
  step = std::move(ahead_.front().step);
  taken_ = std::move(ahead_.front().readings);
  step.readings = taken_;
  ahead_.pop_front();
  return true;
}

/// Where the table lacks the step before this one, no counter has a reading in it.
void CounterReadings::forget_steps_before_a_gap(const TimeStep& step) {
  const ParsedTime time = calendar_time(step.time, step.written);
  if (!time || !time_before_ || !*time_before_) return;
  if (!usual_step_.lacks_between(time_before_->time, time.time)) return;
  for (Counter& counter : counters_) counter.is_of_last_step = false;
}

void CounterReadings::require_order(const TimeStep& step) {
  const ParsedTime time = calendar_time(step.time, step.written);
  if (time && time_before_ && *time_before_ &&
      order_of_moments(time.time, time_before_->time) == std::strong_ordering::less) {
    throw Error({file_, step.line,
                 "time " + quoted(step.time, longest_time) + " comes after " +
                     quoted(text_before_, longest_time) +
                     ", and differences of counters are taken in the order of time",
                 "sort the file by its times"});
  }
  time_before_ = time;
  text_before_ = step.time;
}

double CounterReadings::rain_of(std::size_t station, double reading, const TimeStep& step) {
  const Counter& counter = counters_[station];
  if (std::isnan(counter.last)) return none;
  const bool is_reset = reading < counter.last;
  const double amount = is_reset ? reading : reading - counter.last;
  if (is_reset) note(resets_, station, reading, step);
  if (counter.is_of_last_step || (amount == 0 && !is_reset)) return amount;
  note(left_out_, station, amount, step);
  return none;
}

void CounterReadings::note(Event& event, std::size_t station, double amount, const TimeStep& step) {
  if (event.count++ == 0) {
    event.line = step.line;
    event.first = "of station " + quoted(stations_[station].id, 80) + " at " +
                  quoted(step.time, longest_time);
  }
  event.largest = std::fmax(event.largest, amount);
}

void CounterReadings::conclude() {
  if (resets_.count > 0) {
    warnings_.add({file_, resets_.line,
                   "the counter " + resets_.first + " falls" + others(resets_.count) +
                       ": taken for a reset, so that what it reads then fell in that step (" +
                       shortest_text(resets_.largest) + " at most)",
                   ""});
  }
  if (left_out_.count > 0) {
    warnings_.add({file_, left_out_.line,
                   "the counter " + left_out_.first + " has no reading in the step before" +
                       others(left_out_.count) +
                       ": what it has counted since fell in several steps and is left out (" +
                       shortest_text(left_out_.largest) + " at most)",
                   ""});
  }
  resets_ = left_out_ = {};  // so that each is told once
}

}  // namespace thiessen
