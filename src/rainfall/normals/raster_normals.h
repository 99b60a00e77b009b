#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "basin/basin.h"
#include "rainfall/normals/normal_field.h"
#include "rainfall/normals/pixel_integrals.h"
#include "rainfall/normals/pixel_mapping.h"

namespace thiessen {

/// A window of a raster of normals over a basin, and how the study's points come into it.
struct NormalWindow {
  PixelIntegrals pixels;
  std::unique_ptr<const PixelMapping> mapping;
  /// Whether what is counter-clockwise in the study is so in a picture of the raster too, as it is
  /// where the first row is the northernmost.
  bool keeps_turns = true;
  /// Whether all of the basin lies in the window; else what lies beyond has no normals.
  bool holds_all = true;
  /// On the Earth: the longitude of the basin's middle, near which its longitudes run on.
  double middle_longitude = 0;
};

/// The normals of a raster over one basin. Edges of ground are followed into the raster: straight
/// where its coordinates are the study's, else in pieces that are parabolas there. What is between
/// a chord and the true edge (a bulge) has the normals along the chord.
class RasterBasinNormals : public BasinNormals {
 public:
  /// The window's references are to be as large as its normals are: see PixelIntegrals. `area` is
  /// the basin's.
  RasterBasinNormals(NormalWindow window, const Basin& basin, double area);

  bool is_uniform() const override { return false; }
  const GroundMeasure* measure() const override { return measure_.get(); }
  std::unique_ptr<const GroundMeasure> measure_in(const GnomonicChart& chart) const override;
  GroundNormal of(std::span<const double> figures, double area, std::size_t month) const override;
  GroundNormal whole(std::size_t month) const override { return whole_[month]; }
  double at(Point p, std::size_t month) const override;

 private:
  NormalWindow window_;
  std::vector<GroundNormal> whole_;  // by month
  std::unique_ptr<const GroundMeasure> measure_;
};

/// Normals of a raster: a pixel is a polygon of one value.
class RasterNormals : public NormalField {
 public:
  /// `gauges` has the normals of each station, month by month; `windows` and `areas` are those of
  /// the basins in their order.
  RasterNormals(std::vector<std::vector<double>> gauges, std::vector<NormalWindow> windows,
                const std::vector<Basin>& basins, const std::vector<double>& areas);

  std::size_t months() const override { return gauges_.front().size(); }
  double at_gauge(StationIndex station, std::size_t month) const override {
    return gauges_[index(station)][month];
  }
  const BasinNormals& in(std::size_t basin) const override { return *basins_[basin]; }

 private:
  std::vector<std::vector<double>> gauges_;
  std::vector<std::unique_ptr<const RasterBasinNormals>> basins_;
};

}  // namespace thiessen
