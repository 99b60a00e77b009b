#include "results/weights_file.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/number.h"
#include "base/parallel.h"
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

/// How many columns of factors there are.
std::size_t factors_in(const Weighing& weighing,
                       const std::vector<std::vector<BasinWeights>>& weights) {
  return weighing.normals() == nullptr ? 0 : weights.size();
}

/// What is behind the name of a month's column, where there are several.
std::string of_month(std::size_t month, std::size_t months) {
  if (months == 1) return {};
  return (month < 9 ? "_0" : "_") + std::to_string(month + 1);
}

/// The rows of weights, basin after basin, as texts.
class WeightTexts {
 public:
  WeightTexts(const Weighing& weighing, const std::vector<std::vector<BasinWeights>>& weights,
              AreaUnit unit)
      : weighing_(weighing), weights_(weights), unit_(unit) {
    begins_.reserve(weights.front().size() + 1);
    begins_.push_back(0);
    for (const BasinWeights& basin : weights.front())
      begins_.push_back(begins_.back() + basin.stations.size());
  }

  std::size_t rows() const { return begins_.back(); }
  /// Appends so many rows, from a given one on.
  void append(std::string& out, std::size_t row, std::size_t count) const {
    const auto after = std::upper_bound(begins_.begin(), begins_.end(), row);
    auto basin = static_cast<std::size_t>(after - begins_.begin()) - 1;
    for (const std::size_t end = row + count; row < end; ++row) {
      while (row == begins_[basin + 1]) ++basin;
      append_row(out, basin, row - begins_[basin]);
    }
  }

 private:
  void append_row(std::string& out, std::size_t basin, std::size_t i) const {
    const StationWeight& s = weights_.front()[basin].stations[i];
    append_ids(out, weighing_, basin, s.station);
    append_part(out, s, unit_);
    for (std::size_t m = 0; m < factors_in(weighing_, weights_); ++m) {
      out += ',';
      append_shortest(out, weights_[m][basin].stations[i].factor);
    }
    out += '\n';
  }

  const Weighing& weighing_;
  const std::vector<std::vector<BasinWeights>>& weights_;
  AreaUnit unit_;
  std::vector<std::size_t> begins_;  ///< of each basin, its first row; and the end
};

}  // namespace

std::vector<WeightRow> weight_rows(const Weighing& weighing,
                                   const std::vector<BasinWeights>& weights, AreaUnit unit) {
  std::vector<WeightRow> rows;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    for (const StationWeight& weight : weights[b].stations) {
      rows.push_back({weighing.basins()[b].id,
                      weighing.network().stations()[index(weight.station)].id,
                      weight.area * unit.km2, weight.weight, weight.factor});
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
                   const std::vector<std::vector<BasinWeights>>& weights, AreaUnit unit,
                   unsigned threads) {
  std::string header = std::string("basin,station,") + unit.column() + ",weight";
  for (std::size_t m = 0; m < factors_in(weighing, weights); ++m)
    header += ",factor" + of_month(m, weights.size());
  file.append(header + '\n');
  const WeightTexts texts(weighing, weights, unit);
  constexpr std::size_t rows_in_block = 4096;
  constexpr std::size_t blocks_a_thread = 4;
  std::vector<std::string> blocks(threads > 1 ? threads * blocks_a_thread : 1);
  const std::size_t rows_at_once = rows_in_block * blocks.size();
  for (std::size_t first = 0; first < texts.rows(); first += rows_at_once) {
    const std::size_t rows = std::min(rows_at_once, texts.rows() - first);
    in_parallel((rows + rows_in_block - 1) / rows_in_block, threads,
                [&](std::size_t, std::size_t i) {
                  blocks[i].clear();
                  const std::size_t begin = i * rows_in_block;
                  texts.append(blocks[i], first + begin, std::min(rows_in_block, rows - begin));
                });
    for (std::size_t begin = 0; begin < rows; begin += rows_in_block)
      file.append(blocks[begin / rows_in_block]);
  }
}

void write_changed_weights(OutputFile& file, const Weighing& weighing,
                           const std::vector<std::vector<BasinWeights>>& before,
                           const std::vector<std::vector<BasinWeights>>& after, AreaUnit unit) {
  const std::string area = unit.column();
  std::string header = "basin,station," + area + ",weight," + area + "_after,weight_after";
  for (std::size_t m = 0; m < factors_in(weighing, before); ++m) {
    const std::string factor = ",factor" + of_month(m, before.size());
    header += factor + factor + "_after";
  }
  file.append(header + '\n');
  std::string row;
  for (std::size_t b = 0; b < before.front().size(); ++b) {
    // Normals change factors, and not who weighs: the rows of all months are of the same stations.
    std::vector<std::vector<ChangedWeight>> by_month;
    for (std::size_t m = 0; m < before.size(); ++m)
      by_month.push_back(changed_weights(before[m][b], after[m][b]));
    for (std::size_t i = 0; i < by_month.front().size(); ++i) {
      const ChangedWeight& part = by_month.front()[i];
      row.clear();
      append_ids(row, weighing, b, part.before.station);
      append_part(row, part.before, unit);
      append_part(row, part.after, unit);
      for (std::size_t m = 0; m < factors_in(weighing, before); ++m) {
        for (const StationWeight& its : {by_month[m][i].before, by_month[m][i].after}) {
          row += ',';
          if (its.weight > 0) append_shortest(row, its.factor);
        }
      }
      row += '\n';
      file.append(row);
    }
  }
}

}  // namespace thiessen
