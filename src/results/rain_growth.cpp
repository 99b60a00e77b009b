#include "results/rain_growth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/counted.h"
#include "base/utf8.h"
#include "results/rain_totals_file.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_time = 80;

std::vector<std::size_t> value_columns(std::size_t series, const RainFormat& format,
                                       bool has_totals) {
  std::vector<std::size_t> columns;
  if (format.rows_for_basins) {
    const std::size_t rainfall = (format.methods.empty() ? 2u : 3u) + (format.storms ? 1 : 0);
    columns.push_back(rainfall);
    // Behind what is missing, or behind gauges and coverage.
    if (format.errors) columns.push_back(rainfall + (has_totals ? 2 : 3));
    return columns;
  }
  const std::size_t apart = has_totals ? 2 : 1;  // each total is followed by what it misses
  for (std::size_t i = 0; i < series; ++i) columns.push_back(1 + apart * i);
  for (std::size_t i = 0; format.errors && i < series; ++i)
    columns.push_back(1 + apart * series + i);
  return columns;
}

}  // namespace

RainShape rain_shape(const std::vector<Basin>& basins, const RainFormat& format, bool has_totals) {
  const std::size_t series = basins.size() * std::max<std::size_t>(1, format.methods.size());
  return {has_totals ? totals_header(basins, format) : rain_header(basins, format),
          format.rows_for_basins ? series : 1, value_columns(series, format, has_totals)};
}

RainGrowth::RainGrowth(std::string file, std::string noun, EarlierRain* earlier, int decimals)
    : file_(std::move(file)),
      noun_(std::move(noun)),
      earlier_(earlier),
      unit_(std::pow(10.0, -decimals)) {}

bool RainGrowth::lacks(const std::string& time, std::span<const double> values) {
  const bool begins = begins_counters(values);
  if (earlier_ != nullptr) {
    const StepKey key = step_key(time);
    if (earlier_->steps() > 0) require_alike(key, time);
    if (const std::vector<double>* there = earlier_->find(key)) {
      if (!begins && !are_same(*there, values)) others_.note(time);
      return false;
    }
    if (begins && earlier_->steps() > 0) lost_ = time;
    if (earlier_->steps() > 0 && comes_before(key, earlier_->latest())) late_.note(time);
    const auto& cut = earlier_->cut();
    has_cut_come_ = has_cut_come_ || (cut && cut->key == key);
  }
  ++added_;
  return true;
}

/// Whether these are the values of the first step of counters, of which they tell nothing yet.
bool RainGrowth::begins_counters(std::span<const double> values) {
  if (std::exchange(has_begun_, true) || !is_of_counters_) return false;
  return std::ranges::all_of(values, [](double value) { return std::isnan(value); });
}

void RainGrowth::require_alike(const StepKey& key, const std::string& time) const {
  if (are_alike(earlier_->first(), key)) return;
  throw Error({file_, 0,
               "its times are written as " + quoted(earlier_->first_time(), longest_time) +
                   ", and those of this run as " + quoted(time, longest_time) +
                   ": which steps it lacks cannot be told",
               "times of one series are all moments of one precision, with a zone or without"});
}

bool RainGrowth::are_same(std::span<const double> there, std::span<const double> now) const {
  constexpr double rounding = 1e-6;  // of numbers that have so many decimals
  return std::ranges::equal(there, now, [&](double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) == std::isnan(b);
    return std::fabs(a - b) <= unit_ * (1.5 + rounding);  // one is rounded, the other is not
  });
}

bool RainGrowth::changes() const {
  return earlier_ == nullptr || added_ > 0 || earlier_->cut();
}

std::string RainGrowth::counted(std::size_t count) const {
  return count == 0 ? "no " + noun_ + "s" : thiessen::counted(count, noun_);
}

void RainGrowth::tell_so_far(Warnings& warnings) {
  tell_others(warnings);
  tell_lost(warnings);
}

void RainGrowth::tell_lost(Warnings& warnings) {
  if (lost_.empty()) return;
  warnings.add({file_, 0,
                "the " + noun_ + " " + quoted(lost_, longest_time) +
                    " is added without a value: with it the counters of this run begin, and "
                    "nothing tells what they read in the step before",
                "let each run begin with the last step of the run before, which is passed over"});
  lost_.clear();  // so that it is told once
}

void RainGrowth::tell_others(Warnings& warnings) {
  if (others_.count == 0 || others_told_ > 0) return;
  others_told_ = others_.count;
  const bool one = others_.count == 1;
  warnings.add({file_, 0,
                counted(others_.count) + (one ? " that is there has" : " that are there have") +
                    " other values in this run" + (one ? ", " : ", the first is ") +
                    quoted(others_.first, longest_time) +
                    (one ? ": it stays as it is" : ": they stay as they are"),
                setting("overwrite") + " without " + setting("append") + " writes all anew"});
}

void RainGrowth::conclude(Warnings& warnings) {
  if (earlier_ != nullptr && earlier_->cut() && !has_told_cut_) tell_cut(warnings);
  const std::size_t before = earlier_ == nullptr ? 0 : earlier_->steps();
  warnings.add_notice({file_, 0,
                       counted(added_) + " added, " +
                           (before == 0 ? "none" : std::to_string(before)) +
                           (before == 1 ? " was there" : " were there"),
                       ""});
  if (others_.count > others_told_) others_told_ = 0;
  tell_so_far(warnings);
  if (late_.count == 0) return;
  const bool one = late_.count == 1;
  warnings.add({file_, 0,
                counted(late_.count) + (one ? " added lies" : " added lie") +
                    " before the last that was there" + (one ? ", " : ", the first is ") +
                    quoted(late_.first, longest_time) + ": the table is not in the order of time",
                ""});
}

std::string RainGrowth::cut_in_words() const {
  const CutStep& cut = *earlier_->cut();
  return "its last " + (cut.may_be_whole ? "line has no line end" : noun_ + " is cut off") + ", " +
         quoted(cut.text, longest_time);
}

void RainGrowth::tell_cut_taken_off(Warnings& warnings) {
  if (earlier_ == nullptr || !earlier_->cut()) return;
  has_told_cut_ = true;
  warnings.add({file_, 0, cut_in_words() + ": it is taken off, and added again if it comes", ""});
}

void RainGrowth::tell_cut(Warnings& warnings) const {
  const CutStep& cut = *earlier_->cut();
  if (!has_cut_come_ && cut.may_be_whole) {
    throw Error({file_, 0,
                 cut_in_words() + ": it may be cut off, and " + input("rainfall") +
                     " does not have its " + noun_,
                 "take that line off, or end it"});
  }
  warnings.add({file_, 0,
                cut_in_words() + ": it is taken off" +
                    (has_cut_come_ ? ", and written anew"
                     : cut.key     ? ", and not added again, for it has not come"
                                   : ", and added again if it has come"),
                ""});
}

}  // namespace thiessen
