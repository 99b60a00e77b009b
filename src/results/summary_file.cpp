#include "results/summary_file.h"

#include "base/number.h"
#include "text/csv_writer.h"

namespace thiessen {
namespace {

void append_value(std::string& row, const std::optional<double>& value) {
  row += ',';
  if (value) append_shortest(row, *value);
}

void append_count(std::string& row, std::size_t count) {
  row += ',';
  row += std::to_string(count);
}

}  // namespace

void write_summary(OutputFile& file, std::span<const BasinSummary> basins, AreaUnit unit) {
  file.append(std::string("basin,") + unit.column() +
              ",gauges_inside,gauges_weighing,largest_weight,mean,standard_error,largest,"
              "empty_steps,most_influential,influence");
  std::string row;
  if (!basins.empty()) {
    for (const BasinDepth& depth : basins.front().depths)
      row += ",max_" + depth.length + ",max_" + depth.length + "_time";
  }
  file.append(row + '\n');
  for (const BasinSummary& basin : basins) {
    row.clear();
    append_csv_field(row, basin.basin);
    append_value(row, basin.area);
    append_count(row, basin.gauges_inside);
    append_count(row, basin.gauges_weighing);
    append_value(row, basin.largest_weight);
    append_value(row, basin.mean);
    append_value(row, basin.standard_error);
    append_value(row, basin.largest);
    append_count(row, basin.empty_steps);
    row += ',';
    append_csv_field(row, basin.most_influential);
    append_value(row,
                 basin.most_influential.empty() ? std::nullopt : std::optional(basin.influence));
    for (const BasinDepth& depth : basin.depths) {
      append_value(row, depth.depth);
      row += ',';
      append_csv_field(row, depth.time);
    }
    file.append(row + '\n');
  }
}

}  // namespace thiessen
