#include "rainfall/findings/reading_searches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/calendar_days.h"
#include "rainfall/findings/break_search.h"
#include "rainfall/findings/stuck_search.h"
#include "rainfall/findings/unit_search.h"
#include "rainfall/findings/zero_search.h"
#include "rainfall/network/reporting.h"

namespace thiessen {
namespace {

constexpr std::size_t steps_that_tell = 64;
constexpr std::int64_t half_a_day = 43'200;

/// Hours and shorter steps have their own bounds: what falls in an hour is alike in fewer gauges.
bool is_within_days(const StepLength& step) {
  return step.seconds < half_a_day;
}

/// How many equal readings are too many: 5 days, 12 hours; of shorter steps as many as make 12
/// hours.
std::size_t too_many_equal(const StepLength& step) {
  constexpr std::size_t days = 5;
  constexpr std::int64_t hours = 12;
  if (!is_within_days(step)) return days;
  return static_cast<std::size_t>(std::max(hours, half_a_day / step.seconds));
}

constexpr double spike_in_an_hour = 10;  ///< millimetres

}  // namespace

ReadingSearches::ReadingSearches(const GaugeNeighbours& neighbours, AmountMeaning meaning)
    : neighbours_(neighbours),
      meaning_(meaning),
      wet_(neighbours.gauges() + 1),
      silent_(neighbours.gauges() + 1),
      stretch_(neighbours.gauges()),
      totals_(neighbours) {}

bool ReadingSearches::is_fine() const {
  return length_ && length_->is_a_day_or_less();
}

void ReadingSearches::see(const TimeStep& step) {
  const ParsedTime parsed = calendar_time(step.time, step.written);
  const std::optional<IsoTime> moment = parsed ? std::optional(parsed.time) : std::nullopt;
  if (settled_) return look_at(step.time, moment, step.readings);
  first_.push_back({step.time, moment, {step.readings.begin(), step.readings.end()}});
  intervals_.note(parsed);
  if (first_.size() == steps_that_tell) settle();
}

/// Begins the searches that the steps' length allows, with the first steps.
void ReadingSearches::settle() {
  settled_ = true;
  length_ = intervals_.step();
  if (is_fine()) {
    const double millimetre = meaning_.of_millimetre(length_->seconds);
    of_steps_.push_back(
        std::make_unique<StuckSearch>(neighbours_.gauges(), too_many_equal(*length_)));
    if (neighbours_.gauges() >= least_gauges) {
      const bool within_days = is_within_days(*length_);
      spikes_ = std::make_unique<SpikeSearch>(
          neighbours_, within_days ? std::optional(spike_in_an_hour * millimetre) : std::nullopt);
      of_steps_.push_back(
          std::make_unique<ZeroSearch>(neighbours_, ZeroSearch::much_in_millimetres * millimetre));
      if (length_->seconds == seconds_of_day) shifts_ = std::make_unique<ShiftSearch>(neighbours_);
    }
  }
  stretch_.clear(std::nullopt);
  for (const Step& step : std::exchange(first_, {})) look_at(step.time, step.moment, step.readings);
}

/// Whether a step is the one after the step before, or before it where the file descends.
bool ReadingSearches::follows(const std::optional<IsoTime>& moment) {
  const std::optional<IsoTime> before = std::exchange(before_, moment);
  if (!before || !moment || !length_ || length_->months > 0) return false;
  const std::int64_t between = moment_seconds(*moment) - moment_seconds(*before);
  const bool descends = between < 0;
  const bool turns = std::exchange(descends_, descends) != descends;
  return !turns && (between == length_->seconds || between == -length_->seconds);
}

void ReadingSearches::look_at(const std::string& time, const std::optional<IsoTime>& moment,
                              std::span<const double> readings) {
  const bool follows_last = follows(moment);
  // Where it rains cannot be foreseen: both lists are made without a branch.
  std::size_t wet = 0;
  std::size_t silent = 0;
  for (std::uint32_t g = 0; g < readings.size(); ++g) {
    wet_[wet] = StationIndex{g};
    silent_[silent] = StationIndex{g};
    wet += readings[g] > 0 ? 1u : 0u;
    silent += readings[g] == readings[g] ? 0u : 1u;
  }
  const SeenStep seen{time, readings, std::span(wet_).first(wet), std::span(silent_).first(silent),
                      follows_last};
  const TakeFinding hold = [&](const ReadingFinding& finding) { held_.add(finding); };
  if (spikes_) spikes_->see(seen, hold);
  for (const auto& search : of_steps_) search->see(seen, hold);
  if (neighbours_.gauges() < least_gauges) return;
  const std::optional<int> year = moment ? std::optional(moment->year) : std::nullopt;
  // Without a shift to look for, a stretch need not be of steps that follow each other.
  const bool goes_on = (follows_last || !shifts_) && year == stretch_.year();
  if (stretch_.steps() > 0 && (!goes_on || stretch_.is_full())) close_stretch();
  if (stretch_.steps() == 0) stretch_.clear(year);
  stretch_.set_descends(descends_);
  stretch_.add(seen);
}

void ReadingSearches::close_stretch() {
  if (stretch_.steps() == 0) return;
  totals_.add(stretch_);
  if (shifts_) shifts_->see(stretch_);
  stretch_.clear(std::nullopt);
}

void ReadingSearches::conclude(const TakeFinding& take) {
  if (!settled_) settle();
  if (neighbours_.gauges() >= least_gauges) close_stretch();
  ReportingStations of_other_unit(neighbours_.gauges(), false);
  UnitSearch(totals_).conclude([&](ReadingFinding finding) {
    of_other_unit.set(finding.station, true);
    take(std::move(finding));
  });
  if (shifts_) shifts_->conclude(take);
  BreakSearch(totals_).conclude(take);
  if (spikes_) spikes_->settle([&](StationIndex gauge) { return !of_other_unit[gauge]; });
  held_.pass_on([&](ReadingFinding finding) {
    // Of a gauge in another unit each single reading is wrong, which was said once.
    if (of_other_unit[finding.station] && finding.kind != FindingKind::stuck) return;
    if (finding.kind == FindingKind::spike && !(finding.excess > spikes_->bound())) return;
    take(std::move(finding));
  });
}

bool ReadingSearches::is_sought(FindingKind kind) const {
  return reason_against(kind).empty();
}

std::string ReadingSearches::reason_against(FindingKind kind) const {
  if (kind != FindingKind::stuck && neighbours_.gauges() < least_gauges)
    return "wants " + std::to_string(least_gauges) + " gauges";
  if (kind == FindingKind::unit) {
    return totals_.has_wet_steps(UnitSearch::least_wet_steps)
               ? ""
               : "wants " + std::to_string(UnitSearch::least_wet_steps) + " steps with rain";
  }
  if (kind == FindingKind::jump) {
    return totals_.years().size() < BreakSearch::least_years
               ? "wants " + std::to_string(BreakSearch::least_years) + " years"
               : "";
  }
  if (!length_) return "wants steps of one length";
  if (kind == FindingKind::shift)
    return length_->seconds == seconds_of_day ? "" : "wants steps of a day";
  if (!is_fine()) return "wants steps of a day or less";
  if (kind == FindingKind::spike && std::isnan(spikes_->bound()))
    return "wants more readings above 0";
  return "";
}

}  // namespace thiessen
