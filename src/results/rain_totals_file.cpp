#include "results/rain_totals_file.h"

#include <cmath>
#include <utility>

#include "base/number.h"
#include "results/column_names.h"
#include "text/csv_writer.h"

namespace thiessen {
namespace {

constexpr const char* missing_suffix = "_missing";

}  // namespace

RainTotalsFile::RainTotalsFile(OutputFile& file, const std::vector<Basin>& basins,
                               RainFormat format)
    : file_(file), basins_(basins), format_(std::move(format)) {
  if (format_.rows_for_basins) {
    file_.append(format_.methods.empty() ? "time,basin,rainfall,missing\n"
                                         : "time,basin,method,rainfall,missing\n");
  } else {
    // With several methods the method's name stands between id and suffix, so that no column can be
    // mistaken for another.
    if (format_.methods.empty()) check_column_names(basins_, missing_suffix);
    write_header();
  }
}

void RainTotalsFile::write_header() {
  row_ = "time";
  for (const std::string& column : rain_columns(basins_, format_)) {
    for (const std::string& name : {column, column + missing_suffix}) {
      row_ += ',';
      append_csv_field(row_, name);
    }
  }
  row_ += '\n';
  file_.append(row_);
}

void RainTotalsFile::add(const RainPeriod& period) {
  row_ = format_.rows_for_basins ? "" : period.time;
  for (std::size_t b = 0; b < period.basins.size(); ++b) {
    if (format_.rows_for_basins) append_rain_key(row_, period.time, b, basins_, format_);
    append_total(period.basins[b]);
    if (format_.rows_for_basins) row_ += '\n';
  }
  if (!format_.rows_for_basins) row_ += '\n';
  file_.append(row_);
}

void RainTotalsFile::append_total(const BasinTotal& total) {
  row_ += ',';
  if (!std::isnan(total.rainfall)) append_fixed(row_, total.rainfall, format_.decimals);
  row_ += ',' + std::to_string(total.missing);
}

}  // namespace thiessen
