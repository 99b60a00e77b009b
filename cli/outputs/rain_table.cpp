#include "cli/outputs/rain_table.h"

#include <optional>
#include <string>

#include "base/iso_time.h"
#include "rainfall/series/dated_readings.h"

namespace thiessen::cli {
namespace {

/// A time as ISO 8601 writes it: the end of a day is the beginning of the next, for many that read
/// ISO 8601 know no hour 24.
std::string text_of_time(IsoTime time) {
  if (time.hour == 24) {
    const ParsedTime next = parse_iso_time(time_text(clock_seconds(time), TimePrecision::instant));
    if (next) {
      const std::optional<int> ahead_of_utc = time.ahead_of_utc;
      time = next.time;
      time.ahead_of_utc = ahead_of_utc;
    }
  }
  return iso_text(time);
}

}  // namespace

RainTable::RainTable(OutputFile& file, const std::vector<Basin>& basins, const RainFormat& format,
                     const std::optional<Totalling>& totalling, const std::string& rainfall,
                     RainGrowth* growth)
    : has_patterns_(format.patterns),
      has_rows_for_basins_(format.rows_for_basins),
      has_errors_(format.errors),
      iso_times_(format.iso_times),
      rainfall_(rainfall),
      growth_(growth) {
  if (totalling) {
    totals_.emplace(file, basins, format);
    periods_ = totals_of(*totalling, rainfall, [this](const RainPeriod& period) { add(period); });
  } else {
    steps_.emplace(file, basins, format);
  }
}

void RainTable::prepare(RainStep& step) const {
  if (iso_times_) {
    step.time = text_of_time(
        time_of_step(step.time, TimePrecision::year, rainfall_, step.line, step.written));
    step.written.reset();
  }
  if (steps_ && !has_patterns_) step.text = steps_->text_of(step);
}

void RainTable::add(const RainStep& step, std::size_t pattern) {
  if (periods_) return periods_->add(step);
  if (growth_ != nullptr && is_there(step)) return;
  if (hear_) {
    values_.clear();
    for (const BasinRainfall& basin : step.basins) values_.push_back(basin.rainfall);
    hear_(step.time, values_);
  }
  steps_->append(with_line_ends(has_patterns_ ? steps_->text_of(step, pattern) : step.text));
}

void RainTable::add(const RainPeriod& period) {
  if (growth_ != nullptr && is_there(period)) return;
  if (hear_) {
    values_.clear();
    for (const BasinTotal& total : period.basins) values_.push_back(total.rainfall);
    hear_(period.time, values_);
  }
  totals_->append(with_line_ends(totals_->text_of(period)));
}

/// Whether the table that grows has this step.
bool RainTable::is_there(const RainStep& step) {
  values_.clear();
  for (const BasinRainfall& basin : step.basins) {
    values_.push_back(basin.rainfall);
    if (has_errors_ && has_rows_for_basins_) values_.push_back(basin.standard_error);
  }
  if (has_errors_ && !has_rows_for_basins_) {
    for (const BasinRainfall& basin : step.basins) values_.push_back(basin.standard_error);
  }
  return !growth_->lacks(step.time, values_);
}

bool RainTable::is_there(const RainPeriod& period) {
  values_.clear();
  for (const BasinTotal& total : period.basins) {
    values_.push_back(total.rainfall);
    if (has_errors_ && has_rows_for_basins_) values_.push_back(total.standard_error);
  }
  if (has_errors_ && !has_rows_for_basins_) {
    for (const BasinTotal& total : period.basins) values_.push_back(total.standard_error);
  }
  return !growth_->lacks(period.time, values_);
}

/// The rows with the line ends that the table has already.
std::string RainTable::with_line_ends(std::string text) const {
  if (growth_ == nullptr || !growth_->has_crlf()) return text;
  std::string with_returns;
  for (const char c : text) {
    if (c == '\n') with_returns += '\r';
    with_returns += c;
  }
  return with_returns;
}

void RainTable::finish(Warnings& warnings) {
  if (periods_) periods_->finish(warnings);
}

}  // namespace thiessen::cli
