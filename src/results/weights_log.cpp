#include "results/weights_log.h"

#include "base/number.h"
#include "text/csv_writer.h"

namespace thiessen {

WeightsLog::WeightsLog(OutputFile& file, const Weighing& weighing)
    : file_(file), weighing_(weighing) {
  file_.append("pattern,first_time,basin,station,weight");
  file_.append(weighing.normals() == nullptr ? "\n" : ",factor\n");
}

void WeightsLog::add(std::size_t pattern, std::string_view first_time,
                     const std::vector<BasinWeights>& weights) {
  std::string start = std::to_string(pattern) + ',';
  append_csv_field(start, first_time);
  start += ',';
  std::string rows;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    for (const StationWeight& s : weights[b].stations) {
      rows += start;
      append_csv_field(rows, weighing_.basins()[b].id);
      rows += ',';
      append_csv_field(rows, weighing_.network().stations()[index(s.station)].id);
      rows += ',';
      append_shortest(rows, s.weight);
      if (weighing_.normals() != nullptr) {
        rows += ',';
        append_shortest(rows, s.factor);
      }
      rows += '\n';
    }
  }
  file_.append(rows);
}

}  // namespace thiessen
