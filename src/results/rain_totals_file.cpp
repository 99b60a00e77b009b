#include "results/rain_totals_file.h"

#include <cmath>
#include <utility>

#include "base/number.h"
#include "results/column_names.h"
#include "text/csv_writer.h"

namespace thiessen {
namespace {

constexpr const char* missing_suffix = "_missing";
constexpr const char* error_suffix = "_se";

}  // namespace

RainTotalsFile::RainTotalsFile(OutputFile& file, const std::vector<Basin>& basins,
                               RainFormat format)
    : file_(file), basins_(basins), format_(std::move(format)) {
  // With several methods the method's name stands between id and suffix, so that no column can be
  // mistaken for another.
  if (!format_.rows_for_basins && format_.methods.empty()) {
    check_time_column(basins_);
    check_column_names(basins_, missing_suffix);
    if (format_.errors) check_column_names(basins_, error_suffix);
  }
  if (!format_.continues) file_.append(totals_header(basins_, format_));
}

std::string totals_header(const std::vector<Basin>& basins, const RainFormat& format) {
  if (format.rows_for_basins) {
    std::string row = std::string("time,") + (format.storms ? "last," : "") + "basin," +
                      (format.methods.empty() ? "" : "method,") + "rainfall,missing";
    if (format.errors) row += ",se";
    return row + '\n';
  }
  std::string row = "time";
  const std::vector<std::string> columns = rain_columns(basins, format);
  for (const std::string& column : columns) {
    for (const std::string& name : {column, column + missing_suffix}) {
      row += ',';
      append_csv_field(row, name);
    }
  }
  for (std::size_t i = 0; format.errors && i < columns.size(); ++i) {
    row += ',';
    append_csv_field(row, columns[i] + error_suffix);
  }
  return row + '\n';
}

std::string RainTotalsFile::text_of(const RainPeriod& period) const {
  std::string row = format_.rows_for_basins ? "" : period.time;
  for (std::size_t b = 0; b < period.basins.size(); ++b) {
    if (format_.rows_for_basins && format_.storms) row += period.time + ',';
    if (format_.rows_for_basins)
      append_rain_key(row, format_.storms ? period.last : period.time, b, basins_, format_);
    append_total(row, period.basins[b]);
    if (format_.rows_for_basins) {
      append_error(row, period.basins[b]);
      row += '\n';
    }
  }
  for (std::size_t b = 0; !format_.rows_for_basins && b < period.basins.size(); ++b)
    append_error(row, period.basins[b]);
  if (!format_.rows_for_basins) row += '\n';
  return row;
}

void RainTotalsFile::append_total(std::string& row, const BasinTotal& total) const {
  row += ',';
  if (!std::isnan(total.rainfall)) append_fixed(row, total.rainfall, format_.decimals);
  row += ',' + std::to_string(total.missing);
}

void RainTotalsFile::append_error(std::string& row, const BasinTotal& total) const {
  if (!format_.errors) return;
  row += ',';
  if (!std::isnan(total.standard_error)) append_fixed(row, total.standard_error, format_.decimals);
}

}  // namespace thiessen
