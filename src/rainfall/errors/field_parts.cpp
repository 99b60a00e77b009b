#include "rainfall/errors/field_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "geometry/long_sum.h"

namespace thiessen {
namespace {

bool comes_before(const CellWeight& a, const CellWeight& b) {
  return std::tie(a.basin, a.cell) < std::tie(b.basin, b.cell);
}

bool is_same_cell(const CellWeight& a, const CellWeight& b) {
  return a.basin == b.basin && a.cell == b.cell;
}

}  // namespace

double log_variance(const NormalField& normals, std::size_t basin, const NormalMonth& month) {
  const BasinNormals& of_basin = normals.in(basin);
  if (month) return of_basin.log_variance(*month);
  double sum = 0;
  for (std::size_t m = 0; m < normals.months(); ++m) sum += of_basin.log_variance(m);
  return sum / static_cast<double>(normals.months());
}

FieldParts::FieldParts(std::shared_ptr<const WeighedRainfall> rainfall, const Weighing& weighing,
                       const NormalMonth& month)
    : rainfall_(std::move(rainfall)), network_(weighing.network()), normals_(weighing.normals()) {
  if (!has_normals()) return;
  const std::size_t stations = network_.stations().size();
  for (std::uint32_t s = 0; s < stations; ++s)
    at_gauges_.push_back(relative_at_gauge(*normals_, StationIndex{s}, month));
  const std::size_t basins = weighing.basins().size();
  basin_normals_.assign(basins, 1);
  for (std::size_t b = 0; b < basins; ++b)
    errors_of_normals_.push_back(std::sqrt(log_variance(*normals_, b, month)));
  // Asked for in the way in which a step's weights are, so that those that do not change are the
  // same bit for bit. Where that is too few gauges for a value the full network's are as good.
  std::vector<BasinWeights> all = rainfall_->weights_at(std::vector<double>(stations, 0));
  for (std::size_t b = 0; b < basins; ++b) {
    if (all[b].stations.empty()) all[b] = rainfall_->full_weights()[b];
  }
  std::vector<LongSum> sums(basins);
  for (const CellWeight& part : parts_of(all)) sums[part.basin].add(part.weight);
  for (std::size_t b = 0; b < basins; ++b) basin_normals_[b] = sums[b].value();
  full_ = parts_of(all);
}

std::vector<CellWeight> FieldParts::full() const {
  return has_normals() ? full_ : rainfall_->full_cells();
}

/// The parts of the places, by basin, then by place.
std::vector<CellWeight> FieldParts::parts_of(const std::vector<BasinWeights>& weights) const {
  std::vector<CellWeight> parts;
  for (std::uint32_t b = 0; b < weights.size(); ++b) {
    for (const StationWeight& s : weights[b].stations) {
      parts.push_back({b, network_.place_of(s.station),
                       s.weight * s.factor * at_gauges_[index(s.station)] / basin_normals_[b]});
    }
  }
  // Parts of one place are sorted too, so that their sum does not depend on the stations' order.
  std::sort(parts.begin(), parts.end(), [](const CellWeight& a, const CellWeight& b) {
    return std::tie(a.basin, a.cell, a.weight) < std::tie(b.basin, b.cell, b.weight);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < parts.size();) {
    const CellWeight first = parts[i];
    LongSum sum;
    for (; i < parts.size() && is_same_cell(parts[i], first); ++i) sum.add(parts[i].weight);
    parts[kept++] = {first.basin, first.cell, sum.value()};
  }
  parts.resize(kept);
  return parts;
}

/// By how much the parts of a step are other than those when every gauge reports.
std::vector<CellWeight> FieldParts::change(std::span<const double> readings) const {
  const std::vector<CellWeight> now = parts_of(rainfall_->weights_at(readings));
  std::vector<CellWeight> change;
  auto before = full_.begin();
  for (const CellWeight& part : now) {
    for (; before != full_.end() && comes_before(*before, part); ++before)
      change.push_back({before->basin, before->cell, -before->weight});
    const bool was_there = before != full_.end() && is_same_cell(*before, part);
    const double by = was_there ? part.weight - before->weight : part.weight;
    if (by != 0) change.push_back({part.basin, part.cell, by});
    if (was_there) ++before;
  }
  for (; before != full_.end(); ++before)
    change.push_back({before->basin, before->cell, -before->weight});
  return change;
}

std::vector<BasinRainfall> FieldParts::at(std::span<const double> readings,
                                          CellAccount& account) const {
  if (!has_normals()) return rainfall_->at(readings, account);
  std::vector<double> relative(readings.begin(), readings.end());
  for (std::size_t s = 0; s < relative.size(); ++s) relative[s] /= at_gauges_[s];
  account.readings = rainfall_->cell_readings(relative);
  account.change = change(readings);
  return rainfall_->at(readings);
}

}  // namespace thiessen
