#include "rainfall/series/rain_storms.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "base/utf8.h"
#include "rainfall/series/dated_readings.h"

namespace thiessen {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

bool is_wet(const RainStep& step) {
  return std::ranges::any_of(step.basins, [](const BasinRainfall& b) { return b.rainfall > 0; });
}

bool is_known(const RainStep& step) {
  return std::ranges::none_of(step.basins,
                              [](const BasinRainfall& b) { return std::isnan(b.rainfall); });
}

}  // namespace

RainStorms::RainStorms(Totalling totalling, std::string file, Take take)
    : totalling_(std::move(totalling)),
      file_(std::move(file)),
      take_(std::move(take)),
      sums_(totalling_.depths, totalling_.stamp, totalling_.errors) {}

void RainStorms::add(const RainStep& step) {
  const IsoTime time =
      time_of_step(step.time, totalling_.every.least_precision(), file_, step.line, step.written);
  require_order(time, step);
  intervals_.note({time, IsoTimeFault::none});
  learn_step();
  const std::int64_t moment = moment_seconds(time);
  if (!before_) first_moment_ = moment;
  if (before_) note_lacking(moment);
  before_ = time;
  forget(moment);
  const bool wets = is_wet(step);
  if (open_ && dry_before(moment, last_wet_.moment) >= totalling_.every.dry) end();
  if (wets && !open_) begin(step.basins.size(), moment);
  if (open_) sums_.add(step.basins, time);
  if (wets) wet(time, moment);
  if (is_known(step)) return;
  Unknown unknown{moment, {}, open_};
  for (const BasinRainfall& basin : step.basins)
    unknown.basins.push_back(std::isnan(basin.rainfall));
  unknown_.push_back(std::move(unknown));
}

void RainStorms::require_order(const IsoTime& time, const RainStep& step) {
  if (!before_) return;
  const auto order = order_of_moments(time, *before_);
  const int way = order > 0 ? 1 : -1;
  if (order != 0 && (way_ == 0 || way_ == way)) {
    way_ = way;
    return;
  }
  throw Error({file_, step.line,
               "time " + quoted(step.time, 80) +
                   (order == 0 ? " is that of the step before, written again"
                               : " turns back, and storms want times in their order"),
               order == 0 ? Wording() : Wording("sort the file by time")});
}

/// Takes the step that the times so far tell, where none was known before.
void RainStorms::learn_step() {
  // The intervals are looked at now and then, for that costs the square of how many differ.
  if (intervals_.times() > 64 && intervals_.times() % 64 != 0) return;
  const std::optional<StepLength> known = totalling_.step ? totalling_.step : intervals_.step();
  if (known && known->months > 0) {
    throw Error(
        {file_, 0,
         "the steps are of " + text_of(*known) + ", and storms lie between dry spells of hours",
         setting("every", "month") + " sums by month"});
  }
  step_ = known ? known->seconds : 0;
}

/// The seconds without rain between a wet step and another that comes behind it.
std::int64_t RainStorms::dry_before(std::int64_t moment, std::int64_t wet) const {
  return std::abs(moment - wet) - step_;
}

/// Takes note of the steps that the file lacks before this one: of those near the storm that is
/// open, and those near this one.
void RainStorms::note_lacking(std::int64_t moment) {
  if (step_ == 0) return;
  const std::int64_t before = moment_seconds(*before_);
  const std::int64_t lacking =
      std::abs(moment - before) / step_ - (std::abs(moment - before) % step_ == 0 ? 1 : 0);
  const std::int64_t way = moment > before ? step_ : -step_;
  const std::int64_t near = totalling_.every.dry / step_ + 1;
  for (std::int64_t i = 1; i <= lacking; ++i) {
    if (i > near && i + near < lacking) {  // what lies between is near to nothing
      const std::int64_t far = lacking - near - i;
      unknown_between_ += static_cast<std::size_t>(far);
      i += far - 1;
      continue;
    }
    Unknown unknown{before + i * way, {}, false};
    const bool is_near =
        open_ && dry_before(unknown.moment, last_wet_.moment) < totalling_.every.dry;
    if (is_near) lack(unknown);
    unknown.counts = is_near;
    forget(unknown.moment);
    unknown_.push_back(std::move(unknown));
  }
}

/// Forgets what is too far from a step to be of a storm that begins with it.
void RainStorms::forget(std::int64_t moment) {
  while (!unknown_.empty() && dry_before(moment, unknown_.front().moment) >= totalling_.every.dry) {
    unknown_between_ += unknown_.front().counts ? 0u : 1u;
    unknown_.pop_front();
  }
}

void RainStorms::begin(std::size_t basins, std::int64_t moment) {
  sums_.begin(basins);
  open_ = true;
  lacking_ = 0;
  begins_with_file_ =
      begins_with_file_ || (!any_ && std::abs(moment - first_moment_) < totalling_.every.dry);
  any_ = true;
  lacks_begin_ = true;
  for (Unknown& unknown : unknown_) {
    lack(unknown);
    unknown.counts = true;
  }
}

void RainStorms::wet(const IsoTime& time, std::int64_t moment) {
  last_wet_ = {moment, time};
  if (lacks_begin_) begun_ = last_wet_;
  lacks_begin_ = false;
}

/// Has a step be missing in the open storm.
void RainStorms::lack(const Unknown& unknown) {
  if (unknown.basins.empty()) ++lacking_;
  for (std::size_t b = 0; b < sums_.basins(); ++b) {
    if (unknown.basins.empty() || unknown.basins[b]) sums_.lack(b, 1);
  }
}

/// What a rate of 1 counts for, where the step of rates was not known before.
double RainStorms::depth_of_rate() const {
  if (!totalling_.rates) return 1;
  if (step_ == 0)
    throw rates_without_step(file_, totalling_.rates->unit, "the times so far tell none");
  return static_cast<double>(step_) / static_cast<double>(totalling_.rates->rate.seconds);
}

/// Hands on the open storm.
void RainStorms::end() {
  open_ = false;
  sums_.totals(depth_of_rate(), taken_);
  const bool ascends = last_wet_.moment >= begun_.moment;
  const Wet& first = ascends ? begun_ : last_wet_;
  const Wet& last = ascends ? last_wet_ : begun_;
  RainPeriod storm{
      iso_text(first.time), taken_, {first.time, IsoTimeFault::none}, iso_text(last.time)};
  for (BasinTotal& total : storm.basins) {
    if (total.missing > totalling_.allowed_missing)
      total.rainfall = total.standard_error = no_value;
  }
  if (lacking_ > 0 && ++lacking_storms_ == 1)
    first_lacking_ = storm.time + ", which lacks " + std::to_string(lacking_);
  take_(storm);
}

void RainStorms::finish(Warnings& warnings) {
  bool may_go_on = false;
  if (open_) {
    // The file is known up to the end of its last step, or down to the beginning.
    may_go_on =
        dry_before(moment_seconds(*before_), last_wet_.moment) + step_ < totalling_.every.dry;
    if (may_go_on && totalling_.whole_alone && way_ >= 0) {
      open_ = false;
      warnings.add_notice(
          {file_, 0,
           "the last storm, of " + iso_text(begun_.time) + ", is left out, as it may not be over",
           ""});
      may_go_on = false;
    } else {
      end();
    }
  }
  for (const Unknown& unknown : unknown_) unknown_between_ += unknown.counts ? 0u : 1u;
  if (begins_with_file_ || may_go_on) {
    const char* which = begins_with_file_ && may_go_on
                            ? "no dry spell comes before the first storm, nor after the last"
                        : begins_with_file_ ? "no dry spell comes before the first storm"
                                            : "no dry spell comes after the last storm";
    warnings.add_notice(
        {file_, 0, which + std::string(": the file may begin or end within one"), ""});
  }
  warn_of_unknown(warnings);
}

void RainStorms::warn_of_unknown(Warnings& warnings) const {
  if (step_ > totalling_.every.dry) {
    warnings.add_notice({file_, 0,
                         "steps of " + text_of(StepLength{0, step_}) +
                             " are longer than the dry spell that ends a storm, " +
                             text_of(StepLength{0, totalling_.every.dry}) +
                             ": every dry step ends one",
                         ""});
  }
  if (intervals_.times() > 1 && step_ == 0) {
    warnings.add(
        {file_, 0,
         "the times have no regular step: a dry spell lasts from one wet time to the next, "
         "and steps that the file lacks inside a storm are not counted as missing",
         ""});
  }
  if (unknown_between_ > 0) {
    warnings.add({file_, 0,
                  std::to_string(unknown_between_) +
                      (unknown_between_ == 1 ? " step that lies" : " steps that lie") +
                      " in no storm " + (unknown_between_ == 1 ? "lacks" : "lack") +
                      " values: what fell in them is not told",
                  ""});
  }
  if (lacking_storms_ == 0) return;
  const bool one = lacking_storms_ == 1;
  warnings.add({file_, 0,
                (one ? "a storm lacks steps of "
                     : std::to_string(lacking_storms_) + " storms lack steps of ") +
                    text_of(StepLength{0, step_}) + (one ? ": " : ", the first is ") +
                    first_lacking_ + "; they count as missing",
                setting("allow_missing") + " says how many a total may lack"});
}

}  // namespace thiessen
