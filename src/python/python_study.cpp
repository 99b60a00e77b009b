#include "python/python_study.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "cli/inputs/fitted_normals_of.h"
#include "cli/inputs/gauges.h"
#include "cli/inputs/summed_rates.h"
#include "cli/options/usage_error.h"
#include "cli/outputs/cell_features.h"
#include "files/rainfall/full_network.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/errors_of_series.h"
#include "rainfall/gaps/handover.h"
#include "rainfall/influence/step_blocks.h"
#include "rainfall/methods/rain_methods.h"
#include "rainfall/series/dated_readings.h"
#include "rainfall/series/rain_series.h"
#include "rainfall/series/step_sample.h"
#include "results/column_names.h"
#include "study/network_change.h"

namespace thiessen::python {
namespace {

constexpr std::size_t steps_in_a_block = 64;

/// Settles the CRS of what is in memory as that of files is: a keyword may name the CRS of
/// coordinates that have none, and may not say another than they have.
template <typename File>
void settle_crs(File& file, const std::string& said, const char* keyword) {
  if (said.empty()) return;
  const Crs wanted = Crs::from_text(said, setting(keyword));
  const bool has_own = file.crs && file.crs_origin == CrsOrigin::object;
  if (has_own && !file.crs->same_as(wanted)) {
    throw Error(Message{file.file, 0,
                        "their CRS is " + file.crs->name() + ", and not " + wanted.name() + " as " +
                            setting(keyword) + " says",
                        "leave " + setting(keyword) + " out: it is for coordinates without a CRS"});
  }
  file.crs = wanted;
  file.crs_origin = has_own ? CrsOrigin::object : CrsOrigin::option;
}

/// Settles the CRSs of both, and throws Error where nothing says whether coordinates in memory are
/// degrees or those of a plane.
void settle_crs(GivenParts& given, const StudyRequest& request) {
  if (given.stations) settle_crs(*given.stations, request.stations.source.crs, "crs");
  if (given.basins) settle_crs(*given.basins, request.basins->source.crs, "basins_crs");
  const bool basins_tell =
      given.basins ? given.basins->crs.has_value() : request.basins.has_value();
  if (!given.stations || given.stations->crs || basins_tell || request.metric ||
      !request.plane.empty()) {
    return;
  }
  throw Error(Message{given.stations->file, 0, "nothing says what the coordinates are",
                      setting("crs", "EPSG:4326") +
                          " for longitude and latitude, another CRS, or " +
                          setting("metric", "planar") + " for a plane"});
}

void add(const RainStep& step, bool in_memory, bool errors, Series& series) {
  if (in_memory) {
    series.steps.push_back(step.line - 1);
  } else {
    series.times.push_back(step.time);
  }
  for (const BasinRainfall& basin : step.basins) {
    series.rainfall.push_back(basin.rainfall);
    if (errors) series.errors.push_back(basin.standard_error);
  }
}

void add(const RainPeriod& period, bool errors, Series& series) {
  series.times.push_back(period.time);
  for (const BasinTotal& total : period.basins) {
    series.rainfall.push_back(total.rainfall);
    if (errors) series.errors.push_back(total.standard_error);
    series.missing.push_back(total.missing);
  }
}

}  // namespace

PythonStudy::PythonStudy(GivenParts given, const Keywords& keywords)
    : keywords_(keywords,
                {given.stations.has_value(), given.basins.has_value(), given.readings.has_value()},
                given.changes ? Call::weights : Call::study, warnings_) {
  if (given.stations && !keywords_.study.elevation_field().empty()) {
    throw cli::UsageError{"--elevation-field is of stations in a file, and these are in memory",
                          "--elevation takes their elevations from a raster"};
  }
  StudyRequest request = keywords_.study.request();
  request.opened_from = opened_gauges;
  settle_crs(given, request);
  StationsFile stations =
      given.stations ? *std::move(given.stations) : read_stations(request.stations, warnings_);
  std::optional<BasinsFile> basins = std::move(given.basins);
  if (!basins && request.basins) basins = read_basins(*request.basins, warnings_);
  for (const Station& station : stations.stations) given_ids_.push_back(station.id);
  auto files = std::make_shared<StudyFiles>(
      study_of(std::move(stations), std::move(basins), request, warnings_));
  keep_full_network(given, *files);
  std::unordered_map<std::string, std::size_t> column_of;
  for (std::size_t i = 0; i < given_ids_.size(); ++i) column_of.emplace(given_ids_[i], i);
  for (const Station& station : files->stations) {
    const auto column = column_of.find(station.id);
    if (column != column_of.end()) columns_.push_back(column->second);  // and is not opened
  }
  inputs_ = std::make_unique<cli::Inputs>(std::move(files), keywords_.study, keywords_.view.margin,
                                          keywords_.common.threads, warnings_);
  cli::fit_normals(*inputs_, keywords_.study, keywords_.rainfall,
                   {.stamp = given.stamp, .threads = keywords_.common.threads}, warnings_);
}

/// Leaves the stations alone that report. Where gauges open and close they all stay, as those that
/// open report nothing yet.
void PythonStudy::keep_full_network(const GivenParts& given, StudyFiles& files) {
  if (given.changes) {
    never_reporting_ = given.never_reporting;
  } else if (given.readings) {
    check_readings(*given.readings, given_ids_);
    thiessen::keep_full_network(files, heard_in(*given.readings), "", warnings_);
  } else {
    cli::keep_full_network(files, keywords_.study, keywords_.rainfall, warnings_);
  }
}

ChangedNetwork PythonStudy::changed_weights(Warnings& warnings) const {
  if (!inputs_->has_basins()) {
    throw cli::UsageError{"without and with_ are about the weights of basins, and there are none",
                          "give basins"};
  }
  const NetworkChange change(inputs_->whole(), keywords_.changes.closed(),
                             inputs_->study().filtered_ids, "without");
  change.warn_of_shared_places(warnings);
  ReportingStations before = change.before();
  ReportingStations after = change.after();
  const std::unordered_set<std::string> never(never_reporting_.begin(), never_reporting_.end());
  const std::vector<Station>& stations = inputs_->network().stations();
  for (std::uint32_t s = 0; s < stations.size(); ++s) {
    if (!never.contains(stations[s].id)) continue;
    before.set(StationIndex{s}, false);
    after.set(StationIndex{s}, false);
  }
  if (!after.any()) {
    throw cli::UsageError{"without closes every gauge that reports",
                          "leave one open, or open one with with_"};
  }
  const auto weights_before = inputs_->weighing().weights_by_month(before, threads());
  const auto weights_after = inputs_->weighing().weights_by_month(after, threads());
  change.warn_of_no_effect(weights_before.front(), weights_after.front(), warnings);
  ChangedNetwork changed;
  for (std::size_t m = 0; m < weights_before.size(); ++m) {
    auto& basins = changed.months.emplace_back();
    for (std::size_t b = 0; b < weights_before[m].size(); ++b)
      basins.push_back(thiessen::changed_weights(weights_before[m][b], weights_after[m][b]));
  }
  for (const Station& station : stations) changed.stations.push_back(station.id);
  return changed;
}

bool PythonStudy::tells_months() const {
  return has_normals() && inputs_->weighing().normals()->months() > 1;
}

std::vector<std::vector<BasinWeights>> PythonStudy::weights() const {
  return inputs_->weighing().weights_by_month(inputs_->all_report(), threads());
}

/// The readings that cells show: the step at `time`, or the means where it is empty.
std::optional<GaugeReadings> PythonStudy::shown(const std::optional<GivenReadings>& readings,
                                                const std::string& time, Warnings& warnings) {
  if (!readings)
    return cli::shown_readings(*inputs_, keywords_.study, keywords_.rainfall, time, warnings);
  DatedRows rows(*readings, columns_);
  if (time.empty()) return read_gauges(rows, inputs_->network(), "");
  const auto steps = cli::shown_steps(rows, inputs_->network(), "", {&time, 1}, warnings);
  cli::require_months(*inputs_, "", steps);
  return steps.front();
}

std::string PythonStudy::cells_geojson(const std::optional<GivenReadings>& readings,
                                       const CellsKeywords& keywords, Warnings& warnings) {
  if (!readings && !has_readings() && !keywords.view.times.empty()) {
    throw cli::UsageError{"--time is about readings, and the study has none",
                          "give RAINFALL to Study"};
  }
  const std::optional<GaugeReadings> found = shown(readings, keywords.view.time(), warnings);
  const GaugeReadings* const values = found ? &*found : nullptr;
  const std::string unit =
      values == nullptr ? "" : cli::unit_shown(values->unit, keywords.view.units, false, "");
  const auto cells = cli::cells_of(*inputs_, values, threads());
  return thiessen::cells_geojson(cli::cells_output(*inputs_, cells, values, keywords_.study, unit),
                                 "the cells", warnings);
}

const cli::RainfallOptions& PythonStudy::files_of(const SeriesKeywords& keywords) const {
  if (keywords.rainfall.given()) return keywords.rainfall;
  if (keywords_.rainfall.given()) return keywords_.rainfall;
  throw cli::UsageError{"there are no readings",
                        "give an array, a frame or a file, here or to the study"};
}

/// Opens readings of which only the steps count whose times are wanted.
std::unique_ptr<Readings> PythonStudy::open(const std::optional<GivenReadings>& readings,
                                            const SeriesKeywords& keywords, Warnings& warnings) {
  const std::optional<StepTimes> wanted = keywords.range.times();
  if (!readings)
    return inputs_->open_readings(keywords_.study, files_of(keywords), warnings, wanted,
                                  keywords.range.stamp());
  std::unique_ptr<Readings> rows = std::make_unique<DatedRows>(*readings, columns_);
  if (!wanted) return rows;
  return std::make_unique<DatedReadings>(std::move(rows), "", *wanted, warnings);
}

/// What tells the months of steps, where months have normals of their own. Takes what files say of
/// their times into the keywords.
std::optional<StepMonths> PythonStudy::months(const std::optional<GivenReadings>& readings,
                                              SeriesKeywords& keywords,
                                              const Readings& opened) const {
  if (!tells_months()) return std::nullopt;
  if (readings) return StepMonths("", keywords.range.stamp());
  keywords.range.settle_stamp(opened.stamp(), files_of(keywords).name());
  return StepMonths(files_of(keywords).name(), keywords.range.stamp());
}

/// Throws where steps need times, and readings in memory have none.
void require_times(const std::optional<GivenReadings>& readings, bool are_needed) {
  if (!readings || !are_needed || !readings->times.empty()) return;
  throw Error({"", 0, "the readings have no times, and normals are of calendar months",
               "a frame has them in its index"});
}

/// The periods over which the steps are summed, if they are.
std::optional<Totalling> PythonStudy::totals(const Readings& opened,
                                             const std::optional<GivenReadings>& readings,
                                             SeriesKeywords& keywords, Warnings& warnings) {
  if (!readings) keywords.range.settle_stamp(opened.stamp(), files_of(keywords).name());
  std::optional<Totalling> totalling = keywords.range.totalling();
  if (totalling && !readings) {
    cli::settle_totals(*totalling, *inputs_, keywords_.study, files_of(keywords), opened.unit(),
                       warnings);
  }
  return totalling;
}

void PythonStudy::read_for_errors(const HeldRows* rows, const std::optional<GivenReadings>& given,
                                  SeriesKeywords& keywords, ErrorsOfSeries& errors) {
  if (rows != nullptr && !tells_months()) {
    std::vector<double> buffer;
    for (std::size_t step = 0; step < rows->size(); ++step) errors.add(rows->row(step, buffer), {});
    return;
  }
  Warnings told_later;  // when the files are read again
  std::unique_ptr<Readings> readings;
  if (given) {
    readings = std::make_unique<DatedRows>(*given, columns_);
  } else {
    readings = inputs_->open_readings(keywords_.study, files_of(keywords), told_later, std::nullopt,
                                      keywords.range.stamp());
  }
  const std::optional<StepMonths> months = this->months(given, keywords, *readings);
  for (TimeStep step; readings->next(step);) {
    throw_if_interrupted();
    errors.add(step.readings,
               months ? months->of(step.time, step.written, step.line) : NormalMonth());
  }
}

/// What computes each step, with its errors where these are wanted, and how these go together
/// where totals want them.
std::unique_ptr<const StepRainfall> PythonStudy::step_rainfall(
    const HeldRows* rows, const std::optional<GivenReadings>& given, SeriesKeywords& keywords,
    std::shared_ptr<const ErrorCorrelation>& in_time, Warnings& warnings) {
  ArealRainfallSettings settings = keywords.gaps.settings();
  settings.accounts = false;
  std::optional<ErrorsOfSeries> errors;
  std::string shortfall;
  AroundRainfall around;
  if (keywords.errors) {
    const auto of =
        keywords.range.totalling() ? ErrorsOfSeries::Of::totals : ErrorsOfSeries::Of::steps;
    read_for_errors(rows, given, keywords, errors.emplace(inputs_->weighing(), of));
    in_time = errors->correlation();
    around = [&](std::unique_ptr<const WeighedRainfall> values, const NormalMonth& month) {
      auto error = errors->of(std::move(values), month, threads());
      shortfall = error->shortfall();
      return error;
    };
  }
  auto rainfall = rainfall_by(keywords.method.methods(), inputs_->weighing(),
                              keywords.method.points(), settings, threads(), warnings, around);
  if (!shortfall.empty()) {
    warnings.add({"", 0, "no standard errors: " + shortfall, ""});
  } else if (in_time && inputs_->weighing().normals() == nullptr) {
    warn_of_lasting_errors(*in_time, "", warnings);
  }
  return rainfall;
}

Series PythonStudy::series_with_names(const SeriesKeywords& keywords) const {
  Series series;
  const std::vector<std::string> methods = names_of_methods(keywords.method.methods());
  if (methods.empty()) {
    const Wording other_ids = setting("basin_id") +
                              " takes the ids of another field, and basin_ids, or a dictionary, "
                              "those of shapes";
    check_time_column(inputs_->basins(), other_ids);
    if (keywords.errors) check_column_names(inputs_->basins(), "_se", other_ids);
    if (keywords.range.totalling()) check_column_names(inputs_->basins(), "_missing", other_ids);
  }
  for (const Basin& basin : inputs_->basins()) {
    if (methods.empty()) series.names.push_back(basin.id);
    for (const std::string& method : methods) series.names.push_back(basin.id + "_" + method);
  }
  return series;
}

void PythonStudy::compute(const HeldRows& rows, const StepRainfall& rainfall, bool errors,
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

Series PythonStudy::rain(const std::optional<GivenReadings>& readings, SeriesKeywords& keywords,
                         Progress& progress, Warnings& warnings) {
  require_times(readings, tells_months());
  Series series = series_with_names(keywords);
  std::optional<HeldRows> rows;
  if (readings) {
    check_readings(readings->matrix, given_ids_);
    rows.emplace(readings->matrix, columns_);
  }
  std::shared_ptr<const ErrorCorrelation> in_time;
  const std::unique_ptr<const StepRainfall> rainfall =
      step_rainfall(rows ? &*rows : nullptr, readings, keywords, in_time, warnings);
  if (rows && !keywords.range.times() && !rainfall->tells_months()) {
    compute(*rows, *rainfall, keywords.errors, series, progress);
    return series;
  }
  const auto opened = open(readings, keywords, warnings);
  if (rows) progress.begin(rows->size());
  std::unique_ptr<RainTotals> periods;
  if (auto totalling = totals(*opened, readings, keywords, warnings)) {
    totalling->errors = in_time;
    periods = totals_of(*totalling, readings ? "" : files_of(keywords).name(),
                        [&](const RainPeriod& period) { add(period, keywords.errors, series); });
  }
  const auto take = [&](const RainStep& step) {
    throw_if_interrupted();
    if (periods) {
      periods->add(step);
    } else {
      add(step, readings.has_value(), keywords.errors, series);
    }
    progress.advance(1);
  };
  SeriesWork work{threads()};
  if (const auto told = months(readings, keywords, *opened)) {
    work.month_of = [told](const RainStep& step) {
      return told->of(step.time, step.written, step.line);
    };
  }
  for_each_step(
      *opened, *rainfall, work, [](RainStep&) {}, take);
  if (periods) periods->finish(warnings);
  return series;
}

std::vector<std::vector<GaugeInfluence>> PythonStudy::influence(
    const std::optional<GivenReadings>& readings, SeriesKeywords& keywords, Progress& progress,
    Warnings& warnings) {
  require_times(readings, tells_months());
  const Handovers handovers(inputs_->weighing(), threads());
  Influence influence(handovers, keywords.gaps.settings().remembered_bytes, threads());
  if (readings) check_readings(readings->matrix, given_ids_);
  if (!readings || keywords.range.times() || tells_months()) {
    const auto opened = open(readings, keywords, warnings);
    MonthOfTime month_of;
    if (const auto told = months(readings, keywords, *opened)) {
      month_of = [told](const TimeStep& step) {
        return told->of(step.time, step.written, step.line);
      };
    }
    for_each_block(*opened, steps_in_a_block, threads(), month_of, [&](const StepBlock& block) {
      throw_if_interrupted();
      influence.add(block.rows, block.months);
      progress.advance(block.rows.size());
    });
    return influence.result();
  }
  const HeldRows rows(readings->matrix, columns_);
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
