#include "results/rain_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number.h"
#include "results/column_names.h"
#include "text/csv_writer.h"

namespace thiessen {
namespace {

constexpr const char* error_suffix = "_se";
constexpr std::size_t bytes_of_a_row = 48;  // about

}  // namespace

std::vector<std::string> rain_columns(const std::vector<Basin>& basins, const RainFormat& format) {
  std::vector<std::string> columns;
  for (const Basin& basin : basins) {
    if (format.methods.empty()) columns.push_back(basin.id);
    for (const std::string& method : format.methods) columns.push_back(basin.id + '_' + method);
  }
  return columns;
}

std::string rain_header(const std::vector<Basin>& basins, const RainFormat& format) {
  std::string row = "time";
  if (format.rows_for_basins) {
    row += format.methods.empty() ? ",basin" : ",basin,method";
    row += ",rainfall,gauges,coverage";
    if (format.errors) row += ",se";
    if (format.patterns) row += ",pattern";
    return row + '\n';
  }
  const std::vector<std::string> columns = rain_columns(basins, format);
  for (const std::string& column : columns) {
    row += ',';
    append_csv_field(row, column);
  }
  for (std::size_t i = 0; format.errors && i < columns.size(); ++i) {
    row += ',';
    append_csv_field(row, columns[i] + error_suffix);
  }
  return row + '\n';
}

void append_rain_key(std::string& row, std::string_view time, std::size_t series,
                     const std::vector<Basin>& basins, const RainFormat& format) {
  const std::size_t methods = std::max<std::size_t>(1, format.methods.size());
  append_csv_field(row, time);
  row += ',';
  append_csv_field(row, basins[series / methods].id);
  if (!format.methods.empty()) row += ',' + format.methods[series % methods];
}

RainFile::RainFile(OutputFile& file, const std::vector<Basin>& basins, RainFormat format)
    : file_(file), basins_(basins), format_(std::move(format)) {
  // With several methods the method's name stands between id and suffix, so that no column can be
  // mistaken for another.
  if (!format_.rows_for_basins && format_.methods.empty()) {
    check_time_column(basins_);
    if (format_.errors) check_column_names(basins_, error_suffix);
  }
  const std::size_t methods = std::max<std::size_t>(1, format_.methods.size());
  for (std::size_t series = 0; format_.rows_for_basins && series < basins_.size() * methods;
       ++series) {
    append_rain_key(keys_.emplace_back(), {}, series, basins_, format_);
    keys_.back() += ',';
  }
  if (!format_.continues) file_.append(rain_header(basins_, format_));
}

std::string RainFile::text_of(const RainStep& step, std::size_t pattern) const {
  if (format_.rows_for_basins) return row_for_each_basin(step, pattern);
  std::string row;
  append_csv_field(row, step.time);
  for (const BasinRainfall& basin : step.basins) {
    row += ',';
    append_value(row, basin.rainfall);
  }
  for (std::size_t b = 0; format_.errors && b < step.basins.size(); ++b) {
    row += ',';
    append_value(row, step.basins[b].standard_error);
  }
  row += '\n';
  return row;
}

void RainFile::append_value(std::string& row, double value) const {
  if (!std::isnan(value)) append_fixed(row, value, format_.decimals);
}

std::string RainFile::row_for_each_basin(const RainStep& step, std::size_t pattern) const {
  std::string time;
  append_csv_field(time, step.time);
  std::string rows;
  rows.reserve(step.basins.size() * (time.size() + bytes_of_a_row));
  for (std::size_t b = 0; b < step.basins.size(); ++b) {
    const BasinRainfall& basin = step.basins[b];
    rows += time;
    rows += keys_[b];
    append_value(rows, basin.rainfall);
    rows += ',';
    rows += std::to_string(basin.gauges);
    rows += ',';
    if (basin.coverage == 1) {
      rows += '1';
    } else {
      append_shortest(rows, basin.coverage);
    }
    if (format_.errors) {
      rows += ',';
      append_value(rows, basin.standard_error);
    }
    if (format_.patterns) rows += ',' + std::to_string(pattern);
    rows += '\n';
  }
  return rows;
}

}  // namespace thiessen
