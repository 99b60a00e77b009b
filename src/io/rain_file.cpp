#include "io/rain_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number.h"
#include "io/csv_writer.h"

namespace thiessen {

std::vector<std::string> rain_columns(const std::vector<Basin>& basins, const RainFormat& format) {
  std::vector<std::string> columns;
  for (const Basin& basin : basins) {
    if (format.methods.empty()) columns.push_back(basin.id);
    for (const std::string& method : format.methods) columns.push_back(basin.id + '_' + method);
  }
  return columns;
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
  if (format_.rows_for_basins) {
    file_.append(format_.methods.empty() ? "time,basin," : "time,basin,method,");
    file_.append(format_.patterns ? "rainfall,gauges,coverage,pattern\n"
                                  : "rainfall,gauges,coverage\n");
    return;
  }
  std::string row = "time";
  for (const std::string& column : rain_columns(basins_, format_)) {
    row += ',';
    append_csv_field(row, column);
  }
  row += '\n';
  file_.append(row);
}

std::string RainFile::text_of(const RainStep& step, std::size_t pattern) const {
  if (format_.rows_for_basins) return row_for_each_basin(step, pattern);
  std::string row;
  append_csv_field(row, step.time);
  for (const BasinRainfall& basin : step.basins) {
    row += ',';
    if (!std::isnan(basin.rainfall)) append_fixed(row, basin.rainfall, format_.decimals);
  }
  row += '\n';
  return row;
}

std::string RainFile::row_for_each_basin(const RainStep& step, std::size_t pattern) const {
  std::string rows;
  for (std::size_t b = 0; b < step.basins.size(); ++b) {
    const BasinRainfall& basin = step.basins[b];
    append_rain_key(rows, step.time, b, basins_, format_);
    rows += ',';
    if (!std::isnan(basin.rainfall)) append_fixed(rows, basin.rainfall, format_.decimals);
    rows += ',' + std::to_string(basin.gauges) + ',';
    append_shortest(rows, basin.coverage);
    if (format_.patterns) rows += ',' + std::to_string(pattern);
    rows += '\n';
  }
  return rows;
}

}  // namespace thiessen
