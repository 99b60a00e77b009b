#include "results/weights_file.h"

#include <cstddef>
#include <string>

#include "base/number.h"
#include "text/csv_writer.h"

namespace thiessen {
namespace {

void append_ids(std::string& row, const Weighing& weighing, std::size_t basin,
                StationIndex station) {
  append_csv_field(row, weighing.basins()[basin].id);
  row += ',';
  append_csv_field(row, weighing.network().stations()[index(station)].id);
}

void append_part(std::string& row, const StationWeight& part, AreaUnit unit) {
  row += ',';
  append_shortest(row, part.area * unit.km2);
  row += ',';
  append_shortest(row, part.weight);
}

}  // namespace

std::vector<WeightRow> weight_rows(const Weighing& weighing,
                                   const std::vector<BasinWeights>& weights, AreaUnit unit) {
  std::vector<WeightRow> rows;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    for (const StationWeight& weight : weights[b].stations) {
      rows.push_back({weighing.basins()[b].id,
                      weighing.network().stations()[index(weight.station)].id,
                      weight.area * unit.km2, weight.weight});
    }
  }
  return rows;
}

std::vector<ChangedWeight> changed_weights(const BasinWeights& before, const BasinWeights& after) {
  std::vector<ChangedWeight> changed;
  auto old_part = before.stations.begin();
  auto new_part = after.stations.begin();
  while (old_part != before.stations.end() || new_part != after.stations.end()) {
    const bool has_old =
        old_part != before.stations.end() &&
        (new_part == after.stations.end() || old_part->station <= new_part->station);
    const bool has_new =
        new_part != after.stations.end() && (!has_old || new_part->station == old_part->station);
    const StationWeight none{has_old ? old_part->station : new_part->station, 0, 0};
    changed.push_back({has_old ? *old_part++ : none, has_new ? *new_part++ : none});
  }
  return changed;
}

void write_weights(OutputFile& file, const Weighing& weighing,
                   const std::vector<BasinWeights>& weights, AreaUnit unit) {
  file.append(std::string("basin,station,") + unit.column() + ",weight\n");
  std::string row;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    for (const StationWeight& s : weights[b].stations) {
      row.clear();
      append_ids(row, weighing, b, s.station);
      append_part(row, s, unit);
      row += '\n';
      file.append(row);
    }
  }
}

void write_changed_weights(OutputFile& file, const Weighing& weighing,
                           const std::vector<BasinWeights>& before,
                           const std::vector<BasinWeights>& after, AreaUnit unit) {
  const std::string area = unit.column();
  file.append("basin,station," + area + ",weight," + area + "_after,weight_after\n");
  std::string row;
  for (std::size_t b = 0; b < before.size(); ++b) {
    for (const ChangedWeight& part : changed_weights(before[b], after[b])) {
      row.clear();
      append_ids(row, weighing, b, part.before.station);
      append_part(row, part.before, unit);
      append_part(row, part.after, unit);
      row += '\n';
      file.append(row);
    }
  }
}

}  // namespace thiessen
