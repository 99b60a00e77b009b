#include "cli/options/options.h"

#include <algorithm>
#include <map>

#include "base/parallel.h"
#include "cli/commands/command.h"
#include "cli/options/help.h"
#include "cli/rain_methods.h"
#include "rainfall/gaps/gap_policies.h"

namespace thiessen::cli {
namespace {

constexpr const char* files =
    "CSV, GeoJSON, GeoPackage, Shapefile, FlatGeobuf, KML, spreadsheet, or PG:...";

/// A value out of a list; anything else is a usage error that names the list.
template <typename Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Value& target,
                        const std::map<std::string, Value>& choices, const std::string& kind,
                        const std::string& help) {
  const auto read = [&app, name, choices, &target](const std::string& text) {
    const auto found = choices.find(text);
    if (found == choices.end()) {
      const std::string wanted = value_of(*app.get_option(name));
      throw CLI::ValidationError(name, "wants " + wanted + ", not '" + printable(text) + "'");
    }
    target = found->second;
  };
  return app.add_option_function<std::string>(name, read, help)->type_name(kind);
}

}  // namespace

void StudyOptions::add_to(CLI::App& app, Need basins_need) {
  app_ = &app;
  app.option_defaults()->group("Stations and basins");
  app.add_option("STATIONS", stations, std::string("rain gauges: ") + files)
      ->required()
      ->type_name("");
  app.add_option("BASINS", basins, "study areas: polygons in any of these")
      ->required(basins_need == Need::required)
      ->type_name("");
  add_text(app, "--id", id_, "FIELD", "the station's id; else found by name");
  add_text(app, "--x", x_, "FIELD", "the station's longitude or easting; else found by name");
  add_text(app, "--y", y_, "FIELD", "the station's latitude or northing; else found by name");
  add_text(app, "--basin-id", basin_id_, "FIELD",
           "the basin's id; features that share one are one basin");
  app.add_option("--crs", crs_,
                 "of the stations, where their file names none (EPSG:32633, WKT, PROJ)")
      ->type_name("CRS");
  app.add_option("--basins-crs", basins_crs_, "of the basins, where their file names none")
      ->type_name("CRS");
  add_text(app, "--stations-layer", stations_layer_, "LAYER",
           "which layer of STATIONS, where the file has several");
  add_text(app, "--basins-layer", basins_layer_, "LAYER",
           "which layer of BASINS, where the file has several");
  add_text(app, "--stations-where", stations_where_, "SQL",
           "only the stations that meet this OGR attribute filter");
  add_text(app, "--basins-where", basins_where_, "SQL", "only the basins that meet it");
  add_separator(app, separator_);
  app.add_flag("--decimal-comma", decimal_comma_, "numbers of CSV files are written 1,5");
  app.option_defaults()->group("Method");
  add_choice<std::string>(
      app, "--metric", metric_, {{"geodesic", "geodesic"}, {"planar", "planar"}}, "geodesic|planar",
      "what near means: the shortest path on the Earth (default where the CRS is known), or "
      "straight distance in the coordinates");
  app.add_option("--plane", plane_, "planar, with both files brought into this CRS first")
      ->type_name("CRS");
  add_number(app, "--tolerance", tolerance_, {1e-3, 1e6, "metres from 0.001 to 1e6"},
             "how far, in metres, a published cell edge may lie from the true one; default 0.1");
}

void StudyOptions::add_attributes_to(CLI::App& app) {
  app.option_defaults()->group("Output");
  app.add_flag("--attributes", attributes, "carry every field of the station onto its cells");
}

StudyRequest StudyOptions::request() const {
  if (app_->count("--plane") > 0 && metric_ == "geodesic") {
    throw UsageError{"--plane is planar, and --metric says geodesic", "leave one of them out"};
  }
  StudyRequest request;
  Source& s = request.stations.source;
  s.file = stations;
  s.layer = stations_layer_;
  s.where = stations_where_;
  s.crs = crs_;
  s.separator = separator_;
  s.decimal_comma = decimal_comma_;
  request.stations.id = id_;
  request.stations.x = x_;
  request.stations.y = y_;
  request.stations.attributes = attributes;
  if (!basins.empty() || app_->count("BASINS") > 0) {
    BasinsRequest& b = request.basins.emplace();
    b.source = {basins,         basins_layer_, basins_where_, basins_crs_,   "basins_layer",
                "basins_where", "basins_crs",  separator_,    decimal_comma_};
    b.id = basin_id_;
  }
  request.opened = opened;
  request.opened_from = "--with";
  check_texts();
  if (!metric_.empty()) request.metric = metric_ == "planar" ? Metric::planar : Metric::geodesic;
  request.plane = plane_;
  request.tolerance = tolerance_;
  return request;
}

void StudyOptions::check_texts() const {
  for (const char* option : {"--crs", "--basins-crs", "--plane"}) {
    if (app_->count(option) > 0 && app_->get_option(option)->as<std::string>().empty()) {
      throw Error({"", 0, std::string(option) + " is empty", "give a CRS such as EPSG:32633"});
    }
  }
}

void RainfallOptions::add_to(CLI::App& app, Need need) {
  app.option_defaults()->group("Readings");
  app.add_option(
         "RAINFALL", rainfall,
         "readings, wide or long: CSV or any of these as a table; - reads standard input; or "
         "GHCN-Daily: a .dly file, or a folder of them")
      ->required(need == Need::required)
      ->type_name("");
  add_meaning_to(app);
}

void RainfallOptions::add_as_option_to(CLI::App& app, const std::string& name,
                                       const std::string& help) {
  add_text(app, name, rainfall, "RAINFALL", help);
  app.option_defaults()->group("Readings");
  add_meaning_to(app);
}

void RainfallOptions::add_meaning_to(CLI::App& app) {
  app.add_option("--missing", readings_.missing,
                 "a further text or number that means no reading; may be repeated")
      ->type_name("V")
      ->allow_extra_args(false);
  app.add_option("--trace", readings_.trace,
                 "a further text or number that means 0; may be repeated")
      ->type_name("V")
      ->allow_extra_args(false);
  add_text(app, "--time-field", readings_.time_field, "FIELD", "the time's column");
  add_text(app, "--station-field", readings_.station_field, "FIELD",
           "the station's column in a long table");
  add_text(app, "--value-field", readings_.value_field, "FIELD",
           "the reading's column in a long table");
  app.add_flag("--ignore-unknown", readings_.ignore_unknown,
               "pass over readings of stations that STATIONS lacks, with a warning");
  app.add_flag("--keep-flagged", readings_.keep_flagged,
               "of .dly files, also the values that failed a check of quality");
}

ReadingsOptions RainfallOptions::readings(bool decimal_comma) const {
  ReadingsOptions options = readings_;
  options.decimal_comma = decimal_comma;
  return options;
}

void GapOptions::add_to(CLI::App& app) {
  app.option_defaults()->group("Method");
  std::map<std::string, Gaps> policies;
  std::string names;
  for (const Gaps gaps : all_gaps) {
    policies.emplace(name_of(gaps), gaps);
    names += (names.empty() ? "" : "|") + std::string(name_of(gaps));
  }
  add_choice<Gaps>(
      app, "--gaps", settings_.gaps, policies, names,
      "what a step with silent gauges gets: the cells of the gauges that report (default), the "
      "full network's weights scaled to them, or no value");
  add_count(app, "--min-gauges", settings_.min_gauges, 1, 1'000'000'000,
            "leave a value empty where fewer gauges weigh; default 1");
  add_cache_to(app);
}

void GapOptions::add_cache_to(CLI::App& app) {
  app.option_defaults()->group("Method");
  add_count(app, "--cache", cache_, 0, 1'000'000,
            "MB of memory for what silent gauges' neighbours take over; default 256. It changes "
            "no value");
}

void MethodOptions::add_to(CLI::App& app) {
  app_ = &app;
  using Methods = std::vector<RainMethod>;
  std::map<std::string, Methods> choices{{"all", {all_methods.begin(), all_methods.end()}}};
  std::string names;
  for (const RainMethod method : all_methods) {
    choices.emplace(name_of(method), Methods{method});
    names += std::string(name_of(method)) + "|";
  }
  app.option_defaults()->group("Method");
  add_choice<Methods>(app, "--method", methods_, choices, names + "all",
                      "the cells (default), the mean of the gauges inside, inverse distance "
                      "squared of the 12 nearest, natural neighbours (outside the gauges' hull "
                      "the nearest gauge), or a column for each, BASIN_thiessen and so on; with "
                      "--long rows with a column method");
  add_count(
      app, "--grid", points_, 1, 100'000,
      "over how many points of a basin idw and natural are averaged, to 100000; default 2000");
}

const std::vector<RainMethod>& MethodOptions::methods() const {
  if (app_->count("--grid") > 0 &&
      std::none_of(methods_.begin(), methods_.end(), averages_points)) {
    throw UsageError{"--grid is about --method idw, natural or all", "leave it out"};
  }
  return methods_;
}

void RainFormatOptions::add_to(CLI::App& app) {
  app.option_defaults()->group("Output");
  app.add_flag("--long", long_,
               "rows time,basin,rainfall,gauges,coverage instead of a column a basin");
  add_count(app, "--decimals", decimals_, 0, 15, "decimals of rainfall; default 3");
}

void PeriodOptions::add_range_to(CLI::App& app) {
  app_ = &app;
  app.option_defaults()->group("Readings");
  add_time(app, "--from", range_.from,
           "only the steps from this time on: a year, month, day or time (ISO 8601), by the file's "
           "own clock");
  add_time(app, "--to", range_.to,
           "only the steps up to this time, and with it: a year, month or day to its end");
}

void PeriodOptions::add_to(CLI::App& app) {
  add_range_to(app);
  app.option_defaults()->group("Output");
  add_choice<std::optional<TimePrecision>>(
      app, "--every", every_,
      {{"day", TimePrecision::day}, {"month", TimePrecision::month}, {"year", TimePrecision::year}},
      "day|month|year",
      "totals over calendar periods instead of a row a step, and beside them, in BASIN_missing, "
      "how many of the period's steps have no value; with --long rows "
      "time,basin,rainfall,missing");
  add_count(app, "--allow-missing", allowed_missing_, 0, 1'000'000'000,
            "with --every: how many steps without a value a total may pass over; with more it is "
            "empty; default 0");
}

std::optional<StepTimes> PeriodOptions::times() const {
  const CLI::Option* allow_missing = app_->get_option_no_throw("--allow-missing");
  if (allow_missing != nullptr && allow_missing->count() > 0 && !every_) {
    throw UsageError{"--allow-missing is about totals, and there is no --every",
                     "give --every day, month or year, or leave it out"};
  }
  if (range_.is_empty()) {
    throw UsageError{"--from " + text_of("--from") + " is after --to " + text_of("--to"), ""};
  }
  if (!range_.from && !range_.to && !every_) return std::nullopt;
  return StepTimes{range_, every_.value_or(TimePrecision::year)};
}

std::optional<Totalling> PeriodOptions::totalling() const {
  if (!every_) return std::nullopt;
  return Totalling{*every_, allowed_missing_};
}

std::string PeriodOptions::text_of(const char* option) const {
  return app_->get_option(option)->as<std::string>();
}

void ViewOptions::add_time_to(CLI::App& app) {
  app.option_defaults()->group("Readings");
  add_text(app, "--time", time, "TIME",
           "show this step; default each gauge's mean over the steps it reports");
}

void ViewOptions::add_margin_to(CLI::App& app) {
  app.option_defaults()->group("Method");
  add_number(app, "--margin", margin, {0, 1000, "percent from 0 to 1000"},
             "without BASINS: how far the study area reaches beyond the stations, in percent of "
             "their extent's "
             "larger side; default 10");
}

void ViewOptions::add_look_to(CLI::App& app) {
  app.option_defaults()->group("Picture");
  app.add_option("--units", units, "what the readings are in; default mm")->type_name("U");
  app.add_option("--title", title, "what stands over the picture")->type_name("T");
  add_size(app, size);
}

void OutputOptions::add_to(CLI::App& app, Need need, const std::string& kind,
                           const std::string& help) {
  app.option_defaults()->group("Output");
  app.add_option("-o,--output", output, help)->required(need == Need::required)->type_name(kind);
  app.add_flag("--overwrite", overwrite_, "replace an output that exists; else that is an error");
}

CommonOptions::CommonOptions() : threads(available_threads()) {}

void CommonOptions::add_to(CLI::App& app) {
  app.option_defaults()->group("General");
  add_count(app, "--threads", threads, 1, 1024,
            "on how many cores; default all; the output does not depend on it");
  app.add_flag("-q,--quiet", quiet, "no warnings, no summary");
}

}  // namespace thiessen::cli
