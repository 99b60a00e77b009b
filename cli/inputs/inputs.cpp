#include "cli/inputs/inputs.h"

#include <cstdint>
#include <span>
#include <utility>

#include "files/normals/field_study.h"
#include "files/normals/raster_study.h"
#include "files/rainfall/event_readings.h"
#include "files/rainfall/exclusions_file.h"
#include "files/rainfall/full_network.h"
#include "files/rainfall/rainfall_file.h"
#include "files/rainfall/totals_file.h"
#include "rainfall/series/watched_readings.h"
#include "readings/excluded_readings.h"
#include "readings/totals/totalled_readings.h"

namespace thiessen::cli {
namespace {

Wording without_rainfall() {
  return "there is no " + input("rainfall");
}

void note_whole_network(const std::string& file, std::size_t stations, const Wording& reason,
                        Warnings& warnings) {
  const std::string who = stations == 1
                              ? "its one station makes the network, whether it reports or not: "
                              : "all " + std::to_string(stations) +
                                    " stations make the network, whether they report or not: ";
  warnings.add_notice({file, 0, who + reason, ""});
}

std::shared_ptr<StudyFiles> read_files(const StudyOptions& options, std::size_t threads,
                                       Warnings& warnings) {
  StudyRequest request = options.request();
  request.threads = static_cast<unsigned>(threads);
  return std::make_shared<StudyFiles>(read_study(request, warnings));
}

ReadingsOptions readings_options(const StudyOptions& study, const RainfallOptions& rainfall) {
  ReadingsOptions options = rainfall.readings(study.csv());
  options.column_of = [request = study.request().stations](const std::string& id) {
    return field_that_holds(request, id);
  };
  return options;
}

/// RAINFALL beside STATIONS and BASINS, which may lie in one folder with it.
RainfallRequest rainfall_request(const StudyOptions& study, const RainfallOptions& rainfall) {
  RainfallRequest request = rainfall.request(study.csv());
  request.beside = {study.stations};
  if (!study.basins.empty()) request.beside.push_back(study.basins);
  return request;
}

/// Opens the readings of some stations, none of which are excluded yet.
std::unique_ptr<Readings> open_all(const StudyOptions& study, const RainfallOptions& rainfall,
                                   std::span<const Station> stations,
                                   std::span<const std::string> passed_over, Warnings& warnings) {
  const ReadingsOptions options = readings_options(study, rainfall);
  if (rainfall.is_event())
    return open_event(study.request().stations, stations, passed_over, options, warnings);
  return open_rainfall(rainfall_request(study, rainfall), stations, passed_over, options, warnings);
}

/// Which readings of some stations count as missing; nothing where none is to.
std::optional<Exclusions> exclusions_of(const StudyOptions& study, const RainfallOptions& rainfall,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        Warnings& warnings) {
  const std::optional<std::string> file = rainfall.exclude();
  if (!file) return std::nullopt;
  const ReadingsOptions options = readings_options(study, rainfall);
  const ReadingsStations known(stations, passed_over, {options.ids_as_numbers, {}});
  return Exclusions(read_exclusions(*file, warnings), known, options.ignore_unknown, warnings);
}

/// Which of the stations that report do so with readings that are not excluded. What is wrong in
/// RAINFALL is met again, and told, when it is read.
ReportingStations reporting_beside_excluded(const StudyOptions& study,
                                            const RainfallOptions& rainfall,
                                            std::span<const Station> stations,
                                            std::span<const std::string> passed_over,
                                            const std::optional<Exclusions>& excluded,
                                            ReportingStations reports) {
  if (!excluded) return reports;
  ReportingStations whole = without(*excluded, reports);
  if (!excluded->partly().any()) return whole;
  try {
    Warnings told_later;
    const auto readings = open_all(study, rainfall, stations, passed_over, told_later);
    return reporting_beside(*excluded, whole, *readings);
  } catch (const Error&) {
    return whole;
  }
}

RainfallRequest totals_request(const StudyOptions& study, const RainfallOptions& rainfall) {
  return rainfall.totals().request(rainfall_request(study, rainfall), study.csv());
}

ReadingsOptions totals_options(const StudyOptions& study, const RainfallOptions& rainfall) {
  return rainfall.totals().readings(readings_options(study, rainfall), study.csv());
}

/// Gauges whose totals are read beside RAINFALL are of the network, too.
void add_stations_with_totals(ReportingStations& report, const StudyFiles& files,
                              const StudyOptions& study, const RainfallOptions& rainfall,
                              std::span<const std::string> filtered,
                              const std::optional<Exclusions>& excluded) {
  if (!rainfall.totals().given()) return;
  const ReportingStations with_totals = stations_with_totals(
      totals_request(study, rainfall), files.stations, filtered, totals_options(study, rainfall));
  for (std::uint32_t s = 0; s < files.stations.size(); ++s) {
    const StationIndex station{s};
    if (with_totals[station] && !(excluded && excluded->whole()[station]))
      report.set(station, true);
  }
}

std::vector<std::string> passed_over(const StudyFiles& files) {
  std::vector<std::string> ids(files.filtered_ids.begin(), files.filtered_ids.end());
  for (const Station& station : files.never_reporting) ids.push_back(station.id);
  return ids;
}

/// The stations and basins, with the stations of the full network alone.
std::shared_ptr<StudyFiles> read_files(const StudyOptions& options, const RainfallOptions& rainfall,
                                       std::size_t threads, Warnings& warnings) {
  std::shared_ptr<StudyFiles> files = read_files(options, threads, warnings);
  keep_full_network(*files, options, rainfall, warnings);
  return files;
}

}  // namespace

void keep_full_network(StudyFiles& files, const StudyOptions& options,
                       const RainfallOptions& rainfall, Warnings& warnings) {
  const std::size_t count = files.stations.size();
  const std::vector<std::string> filtered(files.filtered_ids.begin(), files.filtered_ids.end());
  Warnings told_later;  // what is odd about exclusions, when readings are opened
  if (rainfall.is_event()) {
    const ReportingStations heard = stations_in_event(
        options.request().stations, files.stations, filtered, readings_options(options, rainfall));
    const auto excluded = exclusions_of(options, rainfall, files.stations, filtered, told_later);
    thiessen::keep_full_network(
        files,
        reporting_beside_excluded(options, rainfall, files.stations, filtered, excluded, heard),
        rainfall.name(), warnings);
  } else if (!rainfall.given()) {
    note_whole_network(files.stations_file, count, without_rainfall(), warnings);
  } else if (!can_be_read_again(rainfall_request(options, rainfall))) {
    note_whole_network(rainfall.name(), count, input("rainfall") + " is read only once", warnings);
    const std::optional<Exclusions> excluded =
        exclusions_of(options, rainfall, files.stations, filtered, warnings);
    if (excluded && excluded->whole_gauges() > 0) {
      const ReportingStations report = without(*excluded, ReportingStations(count, true));
      thiessen::keep_full_network(files, report, rainfall.name(), warnings);
    }
  } else {
    const ReportingStations heard =
        stations_that_report(rainfall_request(options, rainfall), files.stations, filtered,
                             readings_options(options, rainfall));
    const auto excluded = exclusions_of(options, rainfall, files.stations, filtered, told_later);
    ReportingStations report =
        reporting_beside_excluded(options, rainfall, files.stations, filtered, excluded, heard);
    add_stations_with_totals(report, files, options, rainfall, filtered, excluded);
    thiessen::keep_full_network(files, report, rainfall.name(), warnings);
  }
}

void note_whole_network(const Inputs& inputs, Warnings& warnings) {
  note_whole_network(inputs.study().stations_file, inputs.network().stations().size(),
                     without_rainfall(), warnings);
}

Inputs::Inputs(const StudyOptions& options, double margin, std::size_t threads, Warnings& warnings)
    : Inputs(read_files(options, threads, warnings), options, margin, threads, warnings) {}

Inputs::Inputs(const StudyOptions& options, double margin, const RainfallOptions& rainfall,
               std::size_t threads, Warnings& warnings)
    : Inputs(read_files(options, rainfall, threads, warnings), options, margin, threads, warnings) {
}

Inputs::Inputs(std::shared_ptr<StudyFiles> files, const StudyOptions& options, double margin,
               std::size_t threads, Warnings& warnings)
    : files_(std::move(files)),
      passed_over_(passed_over(*files_)),
      study_(files_, {margin, options.tolerance(), options.allow_far()}, warnings),
      plane_error_(judge_plane(*files_, study_, static_cast<unsigned>(threads), warnings)) {
  if (options.has_normal_raster()) {
    study_.take_normals(normals_of_raster(options.normals(), study_, *files_, warnings));
  } else if (!options.normal_field().empty()) {
    study_.take_normals(normals_of_fields(options.normal_field(), study_, *files_));
  }
}

std::unique_ptr<WatchedReadings> Inputs::open_readings(const StudyOptions& study,
                                                       const RainfallOptions& rainfall,
                                                       Warnings& warnings,
                                                       const std::optional<StepTimes>& wanted,
                                                       std::optional<Stamp> stamp) {
  std::unique_ptr<Readings> readings =
      open_all(study, rainfall, network().stations(), passed_over_, warnings);
  const auto excluded =
      exclusions_of(study, rainfall, network().stations(), passed_over_, warnings);
  ExcludedReadings* before_totals = nullptr;
  if (excluded) {
    auto rest = std::make_unique<ExcludedReadings>(std::move(readings), *excluded, warnings);
    before_totals = rest.get();
    readings = std::move(rest);
  }
  if (rainfall.totals().given()) {
    readings = std::make_unique<TotalledReadings>(
        std::move(readings), rainfall.name(),
        totals_in(totals_request(study, rainfall), network().stations(), passed_over_,
                  totals_options(study, rainfall)),
        rainfall.totals().hour(stamp.value_or(rainfall.stamp())), weighing(), warnings);
    if (excluded) {  // what totals were spread to may be excluded, too
      auto rest = std::make_unique<ExcludedReadings>(std::move(readings), *excluded, warnings);
      rest->tell_for(*before_totals);
      readings = std::move(rest);
    }
  }
  if (wanted) {
    readings =
        std::make_unique<DatedReadings>(std::move(readings), rainfall.name(), *wanted, warnings);
  }
  return std::make_unique<WatchedReadings>(std::move(readings));
}

}  // namespace thiessen::cli
