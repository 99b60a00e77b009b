#include "python/python_study.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "base/utf8.h"
#include "cli/options/usage_error.h"
#include "cli/outputs/cell_features.h"
#include "files/rainfall/full_network.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/rainfall_error.h"
#include "rainfall/gaps/handover.h"
#include "rainfall/influence/step_blocks.h"
#include "rainfall/methods/rain_methods.h"
#include "rainfall/series/rain_series.h"
#include "rainfall/series/step_sample.h"
#include "results/column_names.h"

namespace thiessen::python {
namespace {

constexpr std::size_t steps_in_a_block = 64;

/// Throws Error with the readings in memory that no gauge can have.
void check_readings(const Matrix& readings, const std::vector<std::string>& ids) {
  if (readings.stations != ids.size()) {
    throw Error({"", 0,
                 std::to_string(ids.size()) + " stations were given, and the readings have " +
                     std::to_string(readings.stations) + " columns: one for each is needed",
                 ""});
  }
  Complaints complaints;
  for (std::size_t step = 0; step < readings.steps; ++step) {
    const std::span<const double> row = readings[step];
    for (std::size_t s = 0; s < row.size(); ++s) {
      if (!(row[s] < 0) && !std::isinf(row[s])) continue;
      complaints.add({"", 0,
                      "the reading of station " + quoted(ids[s], 80) + " in row " +
                          std::to_string(step) + " is " +
                          (std::isinf(row[s]) ? "not finite" : "negative"),
                      "a gauge that does not report reads NaN"});
    }
  }
  complaints.throw_if_any();
}

ReportingStations heard_in(const Matrix& readings) {
  ReportingStations heard(readings.stations, false);
  for (std::uint32_t s = 0; s < readings.stations; ++s) {
    for (std::size_t step = 0; step < readings.steps; ++step) {
      if (std::isnan(readings[step][s])) continue;
      heard.set(StationIndex{s}, true);
      break;
    }
  }
  return heard;
}

}  // namespace

/// The rows of a matrix with the network's stations alone. Where these are all stations that were
/// given, a row is the caller's own memory.
class PythonStudy::Rows {
 public:
  Rows(const Matrix& readings, const std::vector<std::size_t>& columns)
      : readings_(readings), columns_(columns) {}

  std::size_t size() const { return readings_.steps; }
  std::span<const double> row(std::size_t step, std::vector<double>& buffer) const {
    const std::span<const double> whole = readings_[step];
    if (columns_.size() == whole.size()) return whole;
    buffer.resize(columns_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i) buffer[i] = whole[columns_[i]];
    return buffer;
  }

 private:
  const Matrix& readings_;
  const std::vector<std::size_t>& columns_;
};

PythonStudy::PythonStudy(GivenParts given, const Keywords& keywords)
    : keywords_(keywords, given.readings.has_value(), warnings_) {
  const StudyRequest request = keywords_.study.request();
  StationsFile stations =
      given.stations ? *std::move(given.stations) : read_stations(request.stations, warnings_);
  std::optional<BasinsFile> basins = std::move(given.basins);
  if (!basins && request.basins) basins = read_basins(*request.basins, warnings_);
  for (const Station& station : stations.stations) given_ids_.push_back(station.id);
  auto files = std::make_shared<StudyFiles>(
      study_of(std::move(stations), std::move(basins), request, warnings_));
  if (given.readings) {
    check_readings(*given.readings, given_ids_);
    keep_full_network(*files, heard_in(*given.readings), "", warnings_);
  } else {
    cli::keep_full_network(*files, keywords_.study, keywords_.rainfall, warnings_);
  }
  std::unordered_map<std::string, std::size_t> column_of;
  for (std::size_t i = 0; i < given_ids_.size(); ++i) column_of.emplace(given_ids_[i], i);
  for (const Station& station : files->stations) columns_.push_back(column_of.at(station.id));
  if (keywords_.study.has_normals()) {
    throw cli::UsageError{"normals are of the program, and the module does not weigh by them",
                          "thiessen weights and thiessen rain do"};
  }
  inputs_ = std::make_unique<cli::Inputs>(std::move(files), keywords_.study, keywords_.view.margin,
                                          keywords_.common.threads, warnings_);
}

std::vector<BasinWeights> PythonStudy::weights() const {
  return inputs_->weighing().weights(inputs_->all_report(), threads());
}

std::string PythonStudy::cells_geojson(Warnings& warnings) const {
  const auto cells = cli::cells_of_network(*inputs_, threads());
  return thiessen::cells_geojson(cli::cells_output(*inputs_, cells, nullptr, keywords_.study, ""),
                                 "the cells", warnings);
}

const cli::RainfallOptions& PythonStudy::files_of(const SeriesKeywords& keywords) const {
  if (keywords.rainfall.given()) return keywords.rainfall;
  if (keywords_.rainfall.given()) return keywords_.rainfall;
  throw cli::UsageError{"there are no readings",
                        "give an array, a frame or a file, here or to the study"};
}

std::unique_ptr<WatchedReadings> PythonStudy::open(const SeriesKeywords& keywords,
                                                   Warnings& warnings) {
  return inputs_->open_readings(keywords_.study, files_of(keywords), warnings,
                                keywords.range.times());
}

std::unique_ptr<const StepRainfall> PythonStudy::errors_of(const ArealRainfall& values,
                                                           const Rows* rows,
                                                           const SeriesKeywords& keywords,
                                                           Warnings& warnings) {
  check_column_names(inputs_->basins(), "_se");
  StepSample sample(columns_.size(), steps_for_errors(columns_.size()));
  if (rows != nullptr) {
    std::vector<double> buffer;
    for (std::size_t step = 0; step < rows->size(); ++step) sample.add(rows->row(step, buffer));
  } else {
    Warnings told_later;  // when the files are read again
    const auto readings =
        inputs_->open_readings(keywords_.study, files_of(keywords), told_later, std::nullopt);
    for (TimeStep step; readings->next(step);) {
      throw_if_interrupted();
      sample.add(step.readings);
    }
  }
  auto errors =
      std::make_unique<const RainfallError>(values, inputs_->weighing(), sample, threads());
  if (!errors->shortfall().empty())
    warnings.add({"", 0, "no standard errors: " + errors->shortfall(), ""});
  return errors;
}

Series PythonStudy::series_with_names(const SeriesKeywords& keywords) const {
  Series series;
  const std::vector<std::string> methods = names_of_methods(keywords.method.methods());
  for (const Basin& basin : inputs_->basins()) {
    if (methods.empty()) series.names.push_back(basin.id);
    for (const std::string& method : methods) series.names.push_back(basin.id + "_" + method);
  }
  return series;
}

void PythonStudy::compute(const Rows& rows, const StepRainfall& rainfall, bool errors,
                          Series& series, Progress& progress) const {
  const std::size_t columns = series.names.size();
  progress.begin(rows.size());
  series.rainfall.resize(rows.size() * columns);
  if (errors) series.errors.resize(series.rainfall.size());
  std::vector<std::vector<double>> buffers(threads());
  in_parallel(rows.size(), threads(), [&](std::size_t worker, std::size_t step) {
    const std::vector<BasinRainfall> values = rainfall.at(rows.row(step, buffers[worker]));
    for (std::size_t c = 0; c < columns; ++c) {
      series.rainfall[step * columns + c] = values[c].rainfall;
      if (errors) series.errors[step * columns + c] = values[c].standard_error;
    }
    progress.advance(1);
  });
}

Series PythonStudy::rain(const std::optional<Matrix>& readings, const SeriesKeywords& keywords,
                         Progress& progress, Warnings& warnings) {
  std::optional<Rows> rows;
  if (readings) {
    check_readings(*readings, given_ids_);
    rows.emplace(*readings, columns_);
  }
  ArealRainfallSettings settings = keywords.gaps.settings();
  settings.accounts = false;
  std::unique_ptr<const ArealRainfall> values;  // has to outlive its errors
  std::unique_ptr<const StepRainfall> rainfall;
  if (keywords.errors) {
    values = std::make_unique<const ArealRainfall>(inputs_->weighing(), settings, threads());
    rainfall = errors_of(*values, rows ? &*rows : nullptr, keywords, warnings);
  } else {
    rainfall = rainfall_by(keywords.method.methods(), inputs_->weighing(), keywords.method.points(),
                           settings, threads(), warnings);
  }
  Series series = series_with_names(keywords);
  if (rows) {
    compute(*rows, *rainfall, keywords.errors, series, progress);
    return series;
  }
  const auto opened = open(keywords, warnings);
  const auto take = [&](const RainStep& step) {
    throw_if_interrupted();
    series.times.push_back(step.time);
    for (const BasinRainfall& basin : step.basins) {
      series.rainfall.push_back(basin.rainfall);
      if (keywords.errors) series.errors.push_back(basin.standard_error);
    }
    progress.advance(1);
  };
  for_each_step(
      *opened, *rainfall, {threads()}, [](RainStep&) {}, take);
  return series;
}

std::vector<std::vector<GaugeInfluence>> PythonStudy::influence(
    const std::optional<Matrix>& readings, const SeriesKeywords& keywords, Progress& progress,
    Warnings& warnings) {
  const Handovers handovers(inputs_->weighing(), threads());
  Influence influence(handovers, keywords.gaps.settings().remembered_bytes, threads());
  if (!readings) {
    const auto opened = open(keywords, warnings);
    for_each_block(*opened, steps_in_a_block, threads(), [&](StepRows block) {
      throw_if_interrupted();
      influence.add(block);
      progress.advance(block.size());
    });
    return influence.result();
  }
  check_readings(*readings, given_ids_);
  const Rows rows(*readings, columns_);
  progress.begin(rows.size());
  std::vector<std::vector<double>> buffers(steps_in_a_block);
  std::vector<std::span<const double>> block;
  for (std::size_t first = 0; first < rows.size(); first += block.size()) {
    throw_if_interrupted();
    block.clear();
    for (std::size_t i = 0; i < steps_in_a_block && first + i < rows.size(); ++i)
      block.push_back(rows.row(first + i, buffers[i]));
    influence.add(block);
    progress.advance(block.size());
  }
  return influence.result();
}

}  // namespace thiessen::python
