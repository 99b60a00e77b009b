#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// A basin with one normal for all its ground.
class UniformBasinNormals : public BasinNormals {
 public:
  /// `normals` has one entry a month.
  explicit UniformBasinNormals(std::vector<double> normals) : normals_(std::move(normals)) {}

  bool is_uniform() const override { return true; }
  const GroundMeasure* measure() const override { return nullptr; }
  std::unique_ptr<const GroundMeasure> measure_in(const GnomonicChart&) const override {
    return nullptr;
  }
  GroundNormal of(std::span<const double>, double, std::size_t month) const override {
    return {normals_[month], 1};
  }
  GroundNormal whole(std::size_t month) const override { return {normals_[month], 1}; }
  double at(Point, std::size_t month) const override { return normals_[month]; }

 private:
  std::vector<double> normals_;
};

/// Normals that are told for each station and for each basin as a whole.
class UniformNormals : public NormalField {
 public:
  /// `gauges` has the normals of each station, month by month, and `basins` those of each basin,
  /// all above 0 and in one unit.
  UniformNormals(std::vector<std::vector<double>> gauges,
                 const std::vector<std::vector<double>>& basins)
      : gauges_(std::move(gauges)), basins_(basins.begin(), basins.end()) {}

  std::size_t months() const override { return gauges_.front().size(); }
  double at_gauge(StationIndex station, std::size_t month) const override {
    return gauges_[index(station)][month];
  }
  const BasinNormals& in(std::size_t basin) const override { return basins_[basin]; }

 private:
  std::vector<std::vector<double>> gauges_;
  std::vector<UniformBasinNormals> basins_;
};

}  // namespace thiessen
