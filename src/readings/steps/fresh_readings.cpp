#include "readings/steps/fresh_readings.h"

#include <utility>

#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_time = 80;

}  // namespace

bool FreshReadings::next(TimeStep& step) {
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  if (std::exchange(has_ahead_, false)) {
    step = std::move(ahead_);
    return true;
  }
  while (read(step)) {
    if (is_fresh(step)) return true;
  }
  conclude();
  return false;
}

bool FreshReadings::is_waiting(std::chrono::milliseconds patience) {
  try {
    while (!has_ahead_ && !at_end_ && !failure_) {
      if (all_->is_waiting(patience)) return true;
      has_ahead_ = read(ahead_) && is_fresh(ahead_);
    }
  } catch (...) {
    failure_ = std::current_exception();
  }
  return false;
}

bool FreshReadings::read(TimeStep& step) {
  if (at_end_) return false;
  at_end_ = !all_->next(step);
  return !at_end_;
}

bool FreshReadings::is_fresh(const TimeStep& step) {
  const GivenSteps::Came came = given_.take(step);
  if (came == GivenSteps::Came::first) return true;
  if (again_++ == 0) first_again_ = step.time;
  if (came == GivenSteps::Came::again_otherwise && !std::exchange(told_otherwise_, true)) {
    warnings_.add({file_, step.line,
                   "time " + quoted(step.time, longest_time) +
                       " comes again with other readings, which are passed over, as are those of "
                       "all steps that come again: what came first stays",
                   ""});
  }
  return false;
}

void FreshReadings::conclude() {
  if (again_ == 0) return;
  const std::size_t again = std::exchange(again_, 0);  // so that it is told once
  warnings_.add_notice({file_, 0,
                        (again == 1 ? "a step that came again is passed over, "
                                    : std::to_string(again) +
                                          " steps that came again are passed over, the first is ") +
                            quoted(first_again_, longest_time),
                        ""});
}

}  // namespace thiessen
