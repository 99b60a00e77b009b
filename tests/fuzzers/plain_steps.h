#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <vector>

#include "base/iso_time.h"
#include "base/utf8.h"
#include "fuzzers/plain_readings.h"
#include "rainfall/series/step_length.h"
#include "readings/times/time_shape.h"

namespace thiessen::fuzzers {

/// The rules of MixedSteps and StepIntervals (mixed_steps.h, step_intervals.h) told once more, over
/// all steps at once, as their judge.
class PlainSteps {
 public:
  explicit PlainSteps(const Steps& steps) : steps_(steps) {
    for (const Step& step : steps) {
      const ParsedTime parsed = parse_iso_time(trimmed(step.time));
      has_other_forms_ = has_other_forms_ || (!parsed && !time_shape(step.time).format.empty());
      if (parsed && times_.size() == static_cast<std::size_t>(&step - steps.data()))
        times_.push_back(parsed.time);
    }
  }

  /// Whether a time may be read that is not of ISO 8601, which this does not judge.
  bool has_other_forms() const { return has_other_forms_; }

  /// Whether a table of these steps is refused: some times have a zone and some none, or some
  /// gauges report in longer steps than the others.
  bool are_mixed() const {
    if (times_.empty() || times_.size() < steps_.size()) return false;  // labels
    const auto is_clocked = [](const IsoTime& time) {
      return time.precision == TimePrecision::instant;
    };
    const auto clocked = std::count_if(times_.begin(), times_.end(), is_clocked);
    const auto zoned = std::count_if(times_.begin(), times_.end(), [](const IsoTime& time) {
      return time.ahead_of_utc.has_value();
    });
    if (zoned > 0 && zoned < clocked) return true;
    TimePrecision finest = TimePrecision::day;
    for (const IsoTime& time : times_) finest = std::max(finest, time.precision);
    const bool is_written = std::any_of(times_.begin(), times_.end(), [&](const IsoTime& time) {
      return time.precision == finest;
    });
    for (std::size_t i = 0; is_written && i < times_.size(); ++i)
      if (times_[i].precision < finest && any_reports(steps_[i])) return true;
    const bool in_months = turn() == times_.size();
    const std::optional<std::int64_t> months = common(true);
    const std::optional<std::int64_t> length = months ? months : common(false);
    if (!length || months.has_value() != in_months) return false;
    std::vector<std::vector<std::int64_t>> all;
    for (std::size_t gauge = 0; gauge < steps_.front().amounts.size(); ++gauge)
      all.push_back(positions(gauge, in_months));
    std::vector<std::int64_t> coarse(all.size(), 0);
    std::vector<std::int64_t> monthly(all.size(), 0);
    for (std::size_t gauge = 0; gauge < all.size(); ++gauge) {
      if (is_coarse(all[gauge], *length)) coarse[gauge] = apart(all[gauge]) / *length;
      const auto at = in_months ? std::vector<std::int64_t>() : months_of(gauge);
      if (is_coarse(at, 0)) monthly[gauge] = apart(at) * 28 * 86'400 / *length;
    }
    return tells(all, coarse) || tells(all, monthly);
  }

 private:
  static bool any_reports(const Step& step) {
    return std::any_of(step.amounts.begin(), step.amounts.end(),
                       [](double amount) { return amount != silent; });
  }
  static std::int64_t position(const IsoTime& time, bool in_months) {
    return in_months ? month_number(time) : moment_seconds(time);
  }
  /// The first time that does not stand in its month as the first of all does; the number of times
  /// where there is none. Months are counted until then.
  std::size_t turn() const {
    std::size_t i = 0;
    while (i < times_.size() && stand_alike_in_months(times_.front(), times_[i])) ++i;
    return i;
  }
  /// The longest interval of which nine in ten of all intervals are multiples.
  std::optional<std::int64_t> common(bool in_months) const {
    std::vector<std::int64_t> lengths;
    for (std::size_t i = 1; i < times_.size(); ++i) {
      if (in_months && !stand_alike_in_months(times_[i - 1], times_[i])) continue;
      lengths.push_back(
          std::abs(position(times_[i], in_months) - position(times_[i - 1], in_months)));
    }
    std::optional<std::int64_t> longest;
    for (const std::int64_t length : lengths) {
      if (length == 0 || (longest && length <= *longest)) continue;
      const auto multiples =
          std::count_if(lengths.begin(), lengths.end(),
                        [length](std::int64_t other) { return other != 0 && other % length == 0; });
      if (10 * static_cast<std::size_t>(multiples) >= 9 * (times_.size() - 1)) longest = length;
    }
    return longest;
  }
  /// Where a gauge reports. Where months turn out not to do, what was counted in them is forgotten,
  /// unless it is one reading at the first time.
  std::vector<std::int64_t> positions(std::size_t gauge, bool in_months) const {
    std::vector<std::int64_t> found;
    const auto gather = [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i)
        if (steps_[i].amounts[gauge] != silent) found.push_back(position(times_[i], in_months));
    };
    gather(0, turn());
    const auto first = position(times_.front(), in_months);
    if (!in_months && (found.size() != 1 || found.front() != first)) found.clear();
    gather(turn(), times_.size());
    return found;
  }
  static std::int64_t apart(const std::vector<std::int64_t>& positions) {
    std::int64_t apart = 0;
    for (const std::int64_t at : positions) apart = std::gcd(apart, at - positions.front());
    return apart;
  }
  /// Whether some gauge's readings, `apart` steps from each other (0: no coarse gauge), hardly
  /// stand so by chance.
  bool tells(const std::vector<std::vector<std::int64_t>>& all,
             const std::vector<std::int64_t>& apart) const {
    double steps = 0;
    double readings = 0;
    for (std::size_t gauge = 0; gauge < all.size(); ++gauge) {
      if (apart[gauge] != 0) continue;
      steps += static_cast<double>(times_.size());
      readings += static_cast<double>(all[gauge].size());
    }
    const double silent_share = (std::max(0.0, steps - readings) + 1) / (steps + 2);
    for (std::size_t gauge = 0; gauge < all.size(); ++gauge) {
      if (apart[gauge] == 0) continue;
      const auto between =
          static_cast<double>(apart[gauge] - 1) * (static_cast<double>(all[gauge].size()) - 1);
      if (static_cast<double>(all.size()) * std::pow(silent_share, between) < 0.01) return true;
    }
    return false;
  }
  /// The months in which a gauge reports, where it does so at the same place in each; else none.
  std::vector<std::int64_t> months_of(std::size_t gauge) const {
    std::vector<IsoTime> times;
    for (std::size_t i = 0; i < times_.size(); ++i)
      if (steps_[i].amounts[gauge] != silent) times.push_back(times_[i]);
    std::vector<std::int64_t> months;
    for (const IsoTime& time : times) {
      if (!stand_alike_in_months(times.front(), time)) return {};
      if (!months.empty() && months.back() == month_number(time)) return {};
      months.push_back(month_number(time));
    }
    return months;
  }
  static bool is_coarse(const std::vector<std::int64_t>& positions, std::int64_t length) {
    if (positions.size() < 3) return false;
    const std::int64_t common = apart(positions);
    if (length > 0 && (common < 2 * length || common % length != 0)) return false;
    const auto [low, high] = std::minmax_element(positions.begin(), positions.end());
    const auto places = static_cast<std::size_t>((*high - *low) / common + 1);
    return places < 2 * positions.size();
  }

  const Steps& steps_;
  std::vector<IsoTime> times_;
  bool has_other_forms_ = false;
};

}  // namespace thiessen::fuzzers
