#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/inputs/inputs.h"
#include "python/held_readings.h"
#include "python/keywords.h"
#include "python/progress.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/errors_of_series.h"
#include "rainfall/influence/influence.h"
#include "rainfall/series/gauge_readings.h"
#include "rainfall/series/rain_totals.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/step_months.h"
#include "results/weights_file.h"

namespace thiessen::python {

/// What messages call the gauges that open, in the place of a file.
inline constexpr const char* opened_gauges = "with_";

/// A series of areal rainfall, a row for each step or, where totals are asked for, each period.
struct Series {
  std::vector<std::string> names;    ///< of its columns: a basin, or BASIN_METHOD
  std::vector<std::string> times;    ///< of files' steps as these have them, and of periods
  std::vector<std::size_t> steps;    ///< of steps in memory: their rows in the caller's order
  std::vector<double> rainfall;      ///< by row, then by column; NaN where there is no value
  std::vector<double> errors;        ///< standard errors; none where they are not asked for
  std::vector<std::size_t> missing;  ///< of totals: how many steps have no value
};

/// The weights of basins' stations before and after gauges close and open, once or, where months
/// have normals of their own, with the factors of each.
struct ChangedNetwork {
  std::vector<std::vector<std::vector<ChangedWeight>>> months;  ///< by month, then by basin
  std::vector<std::string> stations;  ///< the ids of all stations, the opened behind the others
};

/// What the stations and basins of a study are made of, where they are not in files.
struct GivenParts {
  std::optional<StationsFile> stations;
  std::optional<BasinsFile> basins;
  std::optional<Matrix> readings;  ///< they decide which stations are of the network
  Stamp stamp = Stamp::begin;  ///< what times of files' readings are, for normals fitted to them
  /// Whether gauges open and close: all stations are of the network then, whatever they read, and
  /// the ids of those that never report are given.
  bool changes = false;
  std::vector<std::string> never_reporting = {};
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
  bool has_normals() const { return inputs_->weighing().normals() != nullptr; }
  /// Whether what times are of their steps decides something: whose month's normals count, or when
  /// totals ended.
  bool stamp_acts() const { return has_normals() || keywords_.rainfall.totals().given(); }
  /// Whether calendar months have normals of their own, so that steps need times.
  bool tells_months() const;
  /// The weights, once or, where months have normals of their own, with the factors of each.
  std::vector<std::vector<BasinWeights>> weights() const;
  /// The weights before and after the change that the keywords say, of the stations but those that
  /// never report.
  ChangedNetwork changed_weights(Warnings& warnings) const;
  /// The cells as RFC 7946 has them: the bytes of the program's GeoJSON, with the rainfall of the
  /// study's readings, in memory or in files, where it has some.
  std::string cells_geojson(const std::optional<GivenReadings>& readings,
                            const CellsKeywords& keywords, Warnings& warnings);
  /// The series of readings in memory or, where there are none, in files. What the files say of
  /// their times is taken into the keywords.
  Series rain(const std::optional<GivenReadings>& readings, SeriesKeywords& keywords,
              Progress& progress, Warnings& warnings);
  std::vector<std::vector<GaugeInfluence>> influence(const std::optional<GivenReadings>& readings,
                                                     SeriesKeywords& keywords, Progress& progress,
                                                     Warnings& warnings);
  /// What was assumed, found out or mended.
  const Warnings& warnings() const { return warnings_; }

 private:
  void read_for_errors(const HeldRows* rows, const std::optional<GivenReadings>& given,
                       SeriesKeywords& keywords, ErrorsOfSeries& errors);
  std::unique_ptr<const StepRainfall> step_rainfall(
      const HeldRows* rows, const std::optional<GivenReadings>& given, SeriesKeywords& keywords,
      std::shared_ptr<const ErrorCorrelation>& in_time, Warnings& warnings);
  Series series_with_names(const SeriesKeywords& keywords) const;
  void compute(const HeldRows& rows, const StepRainfall& rainfall, bool errors, Series& series,
               Progress& progress) const;
  unsigned threads() const { return static_cast<unsigned>(keywords_.common.threads); }
  std::unique_ptr<Readings> open(const std::optional<GivenReadings>& readings,
                                 const SeriesKeywords& keywords, Warnings& warnings);
  std::optional<Totalling> totals(const Readings& opened,
                                  const std::optional<GivenReadings>& readings,
                                  SeriesKeywords& keywords, Warnings& warnings);
  std::optional<GaugeReadings> shown(const std::optional<GivenReadings>& readings,
                                     const std::string& time, Warnings& warnings);
  void keep_full_network(const GivenParts& given, StudyFiles& files);
  const cli::RainfallOptions& files_of(const SeriesKeywords& keywords) const;
  std::optional<StepMonths> months(const std::optional<GivenReadings>& readings,
                                   SeriesKeywords& keywords, const Readings& opened) const;

  Warnings warnings_;
  StudyKeywords keywords_;
  std::vector<std::string> given_ids_;
  std::vector<std::size_t> columns_;          // of the network's stations among those given
  std::vector<std::string> never_reporting_;  // where gauges open and close
  std::unique_ptr<cli::Inputs> inputs_;
};

}  // namespace thiessen::python
