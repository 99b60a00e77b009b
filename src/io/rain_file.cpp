#include "io/rain_file.h"

#include <cmath>

#include "base/number.h"
#include "io/csv_writer.h"

namespace thiessen {

RainFile::RainFile(OutputFile& file, const std::vector<Basin>& basins, RainFormat format)
    : file_(file), basins_(basins), format_(format) {
  if (format_.rows_for_basins) {
    file_.append("time,basin,rainfall,gauges,coverage\n");
    return;
  }
  row_ = "time";
  for (const Basin& basin : basins_) {
    row_ += ',';
    append_csv_field(row_, basin.id);
  }
  row_ += '\n';
  file_.append(row_);
}

void RainFile::add(const RainStep& step) {
  if (format_.rows_for_basins) {
    add_row_for_each_basin(step);
    return;
  }
  row_.clear();
  append_csv_field(row_, step.time);
  for (const BasinRainfall& basin : step.basins) {
    row_ += ',';
    if (!std::isnan(basin.rainfall)) append_fixed(row_, basin.rainfall, format_.decimals);
  }
  row_ += '\n';
  file_.append(row_);
}

void RainFile::add_row_for_each_basin(const RainStep& step) {
  for (std::size_t b = 0; b < step.basins.size(); ++b) {
    const BasinRainfall& basin = step.basins[b];
    row_.clear();
    append_csv_field(row_, step.time);
    row_ += ',';
    append_csv_field(row_, basins_[b].id);
    row_ += ',';
    if (!std::isnan(basin.rainfall)) append_fixed(row_, basin.rainfall, format_.decimals);
    row_ += ',' + std::to_string(basin.gauges) + ',';
    append_shortest(row_, basin.coverage);
    row_ += '\n';
    file_.append(row_);
  }
}

}  // namespace thiessen
