#include "io/rain_file.h"

#include <cmath>

#include "base/number.h"
#include "io/csv_writer.h"

namespace thiessen {

RainFile::RainFile(OutputFile& file, const std::vector<Basin>& basins, RainFormat format)
    : file_(file), basins_(basins), format_(format) {
  if (format_.rows_for_basins) {
    file_.append(format_.patterns ? "time,basin,rainfall,gauges,coverage,pattern\n"
                                  : "time,basin,rainfall,gauges,coverage\n");
    return;
  }
  std::string row = "time";
  for (const Basin& basin : basins_) {
    row += ',';
    append_csv_field(row, basin.id);
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
    append_csv_field(rows, step.time);
    rows += ',';
    append_csv_field(rows, basins_[b].id);
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
