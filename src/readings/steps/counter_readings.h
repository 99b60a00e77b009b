#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/iso_time.h"
#include "rainfall/network/network.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"
#include "readings/steps/usual_step.h"

namespace thiessen {

/// Readings of counters, which go on rising, taken to what fell in each step.
///
/// A step's rain is what the counter reads less what it read in the step before; the first has
/// none. Where a counter falls it was reset in between, and what it reads then is the step's rain.
/// Where it was silent in the step before, or the table lacks that step (see UsualStep), what it
/// has counted since fell in more than one step, and is no step's rain unless it is nothing. Resets
/// and what was left out so are said in one line each when the last step has been read. The first
/// steps are read ahead, as far as a pipe has brought them, for only those behind a gap at the
/// beginning tell that it is one. Memory: two numbers a gauge, and 16 steps.
class CounterReadings : public Readings {
 public:
  /// The stations and `warnings` must outlive this object. `file` is for messages.
  CounterReadings(std::unique_ptr<Readings> all, std::string file,
                  std::span<const Station> stations, Warnings& warnings);

  /// Throws Error where a step's time is before that of the step before, as differences would be
  /// taken backwards.
  bool next(TimeStep& step) override;
  bool is_waiting(std::chrono::milliseconds patience) override {
    return ahead_.empty() && !failure_ && all_->is_waiting(patience);
  }
  std::optional<Stamp> stamp() const override { return all_->stamp(); }
  double share_read() const override { return all_->share_read(); }

 private:
  /// What the counter of a gauge read last, and whether that was in the step before.
  struct Counter {
    double last;
    bool is_of_last_step = false;
  };
  /// What happened to counters: how often, and where and when first.
  struct Event {
    std::size_t count = 0;
    std::size_t line = 0;
    std::string first;
    double largest = 0;
  };

  /// A step that was read ahead, with readings of its own.
  struct Ahead {
    TimeStep step;
    std::vector<double> readings;
  };

  void read_ahead();
  bool read(TimeStep& step);
  bool take(TimeStep& step);
  void require_order(const TimeStep& step);
  void forget_steps_before_a_gap(const TimeStep& step);
  double rain_of(std::size_t station, double reading, const TimeStep& step);
  void note(Event& event, std::size_t station, double amount, const TimeStep& step);
  void conclude();

  std::unique_ptr<Readings> all_;
  std::string file_;
  std::span<const Station> stations_;
  Warnings& warnings_;
  std::vector<Counter> counters_;
  std::vector<double> amounts_;
  bool has_read_ahead_ = false;
  std::deque<Ahead> ahead_;
  std::vector<double> taken_;   ///< the readings of a step that was read ahead
  std::exception_ptr failure_;  ///< of what was read ahead, for when its turn comes
  UsualStep usual_step_;
  std::optional<ParsedTime> time_before_;
  std::string text_before_;
  Event resets_;
  Event left_out_;
};

}  // namespace thiessen
