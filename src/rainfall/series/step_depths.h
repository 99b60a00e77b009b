#pragma once

#include <string>

#include "base/error.h"
#include "base/iso_time.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/step_length.h"

namespace thiessen {

/// What values that are rates, such as mm/h, count for in a total: the depth that falls in the
/// length of their step at that rate. Months and years are those of the calendar in which the step
/// lies.
class StepDepths {
 public:
  /// `rate`: the time in which a value falls, of seconds, of a month or of a year. `step`: the
  /// length of the file's steps. Requires that neither is 0.
  StepDepths(StepLength rate, StepLength step) : rate_(rate), step_(step) {}

  /// Whether every value is itself the depth of its step.
  bool are_the_values() const { return rate_ == step_; }
  const StepLength& step() const { return step_; }
  /// The depth of a value whose step holds the moment `within`; times with a clock are stamps of
  /// this kind, others are the whole that they name. NaN for NaN.
  double of(double value, const IsoTime& within, Stamp stamp) const;

 private:
  StepLength rate_;
  StepLength step_;
};

/// Rates whose step is not known before they are summed, for they can be read only once.
struct RatesOfUnknownStep {
  StepLength rate;   ///< the time in which a value falls, of seconds
  std::string unit;  ///< of the values, for messages
};

/// The error that the length of the steps of rates is not known, and why.
Error rates_without_step(const std::string& file, const std::string& unit, const std::string& why);

}  // namespace thiessen
