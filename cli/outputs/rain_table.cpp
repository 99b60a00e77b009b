#include "cli/outputs/rain_table.h"

#include "base/iso_time.h"
#include "rainfall/series/dated_readings.h"

namespace thiessen::cli {

RainTable::RainTable(OutputFile& file, const std::vector<Basin>& basins, const RainFormat& format,
                     const std::optional<Totalling>& totalling, const std::string& rainfall)
    : has_patterns_(format.patterns), iso_times_(format.iso_times), rainfall_(rainfall) {
  if (totalling) {
    totals_.emplace(file, basins, format);
    periods_.emplace(*totalling, rainfall,
                     [this](const RainPeriod& period) { totals_->add(period); });
  } else {
    steps_.emplace(file, basins, format);
  }
}

void RainTable::prepare(RainStep& step) const {
  if (iso_times_) {
    step.time =
        iso_text(time_of_step(step.time, TimePrecision::year, rainfall_, step.line, step.written));
    step.written.reset();
  }
  if (steps_ && !has_patterns_) step.text = steps_->text_of(step);
}

void RainTable::add(const RainStep& step, std::size_t pattern) {
  if (periods_) {
    periods_->add(step);
  } else {
    steps_->append(has_patterns_ ? steps_->text_of(step, pattern) : step.text);
  }
}

void RainTable::finish(Warnings& warnings) {
  if (periods_) periods_->finish(warnings);
}

}  // namespace thiessen::cli
