#include "cli/outputs/model_table.h"

#include <cmath>
#include <utility>

#include "base/iso_time.h"
#include "base/utf8.h"
#include "results/models/series_times.h"

namespace thiessen::cli {

ModelTable::ModelTable(std::unique_ptr<ModelSeries> series, std::string format,
                       const std::optional<Totalling>& totalling, std::string rainfall)
    : series_(std::move(series)),
      format_(std::move(format)),
      rainfall_(std::move(rainfall)),
      totals_have_errors_(totalling && totalling->errors) {
  if (totalling) {
    periods_ = totals_of(*totalling, rainfall_, [this](const RainPeriod& period) { add(period); });
  }
}

void ModelTable::add(const RainStep& step, std::size_t /*pattern*/) {
  if (periods_) return periods_->add(step);
  const IsoTime time =
      calendar_time_for("--format " + format_, step.time, step.written, rainfall_, step.line);
  values_.clear();
  errors_.clear();
  for (const BasinRainfall& basin : step.basins) {
    values_.push_back(basin.rainfall);
    errors_.push_back(basin.standard_error);
  }
  series_->add(time, values_, errors_);
}

void ModelTable::add(const RainPeriod& period) {
  if (!period.begin) {
    throw Error({rainfall_, 0,
                 "the period " + quoted(period.time, 80) +
                     " begins beyond the years of the calendar, and --format " + format_ +
                     " has none such",
                 "--to leaves it out"});
  }
  values_.clear();
  errors_.clear();
  for (const BasinTotal& total : period.basins) {
    values_.push_back(total.rainfall);
    if (totals_have_errors_) errors_.push_back(total.standard_error);
    if (total.missing > 0 && !std::isnan(total.rainfall)) ++incomplete_;
  }
  series_->add(period.begin.time, values_, errors_);
}

void ModelTable::finish(Warnings& warnings) {
  if (periods_) periods_->finish(warnings);
  series_->finish(warnings);
  if (incomplete_ == 0) return;
  warnings.add({rainfall_, 0,
                std::to_string(incomplete_) + (incomplete_ == 1 ? " total lacks" : " totals lack") +
                    " steps, and --format " + format_ + " does not say which",
                "--format csv says how many each lacks"});
}

}  // namespace thiessen::cli
