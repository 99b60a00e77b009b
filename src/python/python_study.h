#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/inputs/inputs.h"
#include "python/keywords.h"
#include "python/progress.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/influence/influence.h"

namespace thiessen::python {

/// Readings in the caller's memory, which are not copied: a row for each step and in it a column
/// for each station that was given, in their order. NaN where a gauge is silent.
struct Matrix {
  const double* first = nullptr;
  std::size_t steps = 0;
  std::size_t stations = 0;

  std::span<const double> operator[](std::size_t step) const {
    return {first + step * stations, stations};
  }
};

/// A series of areal rainfall, a row for each step.
struct Series {
  std::vector<std::string> names;  ///< of its columns: a basin, or BASIN_METHOD
  std::vector<std::string> times;  ///< as the file has them; none where readings are in memory
  std::vector<double> rainfall;    ///< by step, then by column; NaN where there is no value
  std::vector<double> errors;      ///< standard errors; none where they are not asked for
};

/// What the stations and basins of a study are made of, where they are not in files.
struct GivenParts {
  std::optional<StationsFile> stations;
  std::optional<BasinsFile> basins;
  std::optional<Matrix> readings;  ///< they decide which stations are of the network
};

/// A study as Python sees it: the same inputs, read and checked, as those of a command of the
/// program, or the same made of what the caller has in memory. No function of it touches an object
/// of Python. Not safe for two calls at once of functions that are not const.
class PythonStudy {
 public:
  /// Throws Error, UsageError and UnknownKeyword.
  PythonStudy(GivenParts given, const Keywords& keywords);

  const cli::Inputs& inputs() const { return *inputs_; }
  /// The ids of all stations, in the order in which they were given.
  const std::vector<std::string>& given_ids() const { return given_ids_; }
  bool has_readings() const { return keywords_.rainfall.given(); }
  std::vector<BasinWeights> weights() const;
  /// The cells as RFC 7946 has them: the bytes of the program's GeoJSON.
  std::string cells_geojson(Warnings& warnings) const;
  /// The series of readings in memory or, where there are none, in files.
  Series rain(const std::optional<Matrix>& readings, const SeriesKeywords& keywords,
              Progress& progress, Warnings& warnings);
  std::vector<std::vector<GaugeInfluence>> influence(const std::optional<Matrix>& readings,
                                                     const SeriesKeywords& keywords,
                                                     Progress& progress, Warnings& warnings);
  /// What was assumed, found out or mended.
  const Warnings& warnings() const { return warnings_; }

 private:
  class Rows;

  std::unique_ptr<const StepRainfall> errors_of(const ArealRainfall& values, const Rows* rows,
                                                const SeriesKeywords& keywords, Warnings& warnings);
  Series series_with_names(const SeriesKeywords& keywords) const;
  void compute(const Rows& rows, const StepRainfall& rainfall, bool errors, Series& series,
               Progress& progress) const;
  unsigned threads() const { return static_cast<unsigned>(keywords_.common.threads); }
  std::unique_ptr<WatchedReadings> open(const SeriesKeywords& keywords, Warnings& warnings);
  const cli::RainfallOptions& files_of(const SeriesKeywords& keywords) const;

  Warnings warnings_;
  StudyKeywords keywords_;
  std::vector<std::string> given_ids_;
  std::vector<std::size_t> columns_;  // of the network's stations among those given
  std::unique_ptr<cli::Inputs> inputs_;
};

}  // namespace thiessen::python
