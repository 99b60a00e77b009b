#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "basin/ground_measure.h"
#include "earth/sphere/gnomonic_chart.h"
#include "geometry/point.h"
#include "rainfall/network/station_index.h"

namespace thiessen {

/// A calendar month from 0, whose normals count; nothing stands for the year.
using NormalMonth = std::optional<std::size_t>;

/// The mean normal over a piece of ground.
struct GroundNormal {
  double mean = 1;     ///< over the ground that has normals; NaN where none has
  double covered = 1;  ///< the share of the ground that has normals
};

/// The normals over one basin. Safe for several threads at once.
class BasinNormals {
 public:
  virtual ~BasinNormals() = default;
  /// Whether the normal is one all over the basin. Then there are no measures, and a piece of
  /// ground has no figures.
  virtual bool is_uniform() const = 0;
  /// What ground of the basin is measured by, whose edges are in the study's coordinates.
  virtual const GroundMeasure* measure() const = 0;
  /// The same for ground whose edges are in a chart; for one thread at a time.
  virtual std::unique_ptr<const GroundMeasure> measure_in(const GnomonicChart& chart) const = 0;
  /// The mean normal over ground with these figures and this area.
  virtual GroundNormal of(std::span<const double> figures, double area,
                          std::size_t month) const = 0;
  /// The mean normal of the whole basin.
  virtual GroundNormal whole(std::size_t month) const = 0;
  /// The normal at a point of the basin; NaN where there is none.
  virtual double at(Point p, std::size_t month) const = 0;
  /// The variance of the logarithm of the basin's mean normal: 0 where normals are given, and so
  /// taken as known.
  virtual double log_variance(std::size_t /*month*/) const { return 0; }
};

/// Normals: long-term means of rainfall over the ground and at the gauges, for the whole year or
/// for each calendar month, in any unit: only ratios count. Where they come from, a raster, fields
/// of the files or a fit, is left to the classes that derive from this. Safe for several threads at
/// once.
class NormalField {
 public:
  NormalField() = default;
  NormalField(const NormalField&) = delete;
  NormalField& operator=(const NormalField&) = delete;
  virtual ~NormalField() = default;

  /// 12 where calendar months have normals of their own, else 1.
  virtual std::size_t months() const = 0;
  /// The normal at a station, in a month from 0; above 0.
  virtual double at_gauge(StationIndex station, std::size_t month) const = 0;
  /// The normal at a station as it is told without the station's own readings: the same where
  /// normals are given.
  virtual double without(StationIndex station, std::size_t month) const {
    return at_gauge(station, month);
  }
  virtual const BasinNormals& in(std::size_t basin) const = 0;
};

/// The months that a field tells apart, and the year last where there are twelve; none without.
std::vector<NormalMonth> months_of(const NormalField* normals);
/// The place of a month, or of the year, among these; 0 without normals.
std::size_t place_of(const NormalField* normals, const NormalMonth& month);

/// The normal at a station in a month, or the mean of the months for the year.
double normal_at_gauge(const NormalField& normals, StationIndex station, const NormalMonth& month);
/// The normal at a station as it is told without the station's own readings, in a month or the
/// year; see NormalField::without.
double normal_without(const NormalField& normals, StationIndex station, const NormalMonth& month);
/// The normal at the first station, by which what is computed with is divided: normals that are the
/// same everywhere are then exactly 1, and change no bit of a value.
inline double reference_normal(const NormalField& normals, const NormalMonth& month) {
  return normal_at_gauge(normals, StationIndex{0}, month);
}
/// The normal at a station relative to that of the first.
inline double relative_at_gauge(const NormalField& normals, StationIndex station,
                                const NormalMonth& month) {
  return normal_at_gauge(normals, station, month) / reference_normal(normals, month);
}
/// The mean normal over ground of a basin in a month or the year; see BasinNormals::of.
GroundNormal normal_over(const NormalField& normals, std::size_t basin,
                         std::span<const double> figures, double area, const NormalMonth& month);
/// The mean normal of a basin in a month or the year.
double basin_normal(const NormalField& normals, std::size_t basin, const NormalMonth& month);
/// The normal at a point of a basin in a month or the year; NaN where there is none.
double normal_at(const NormalField& normals, std::size_t basin, Point p, const NormalMonth& month);

}  // namespace thiessen
