#include "cli/options/blocks/study_options.h"

#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"
#include "study/study.h"

namespace thiessen::cli {
namespace {

constexpr const char* formats =
    "CSV, GeoJSON, GeoPackage, Shapefile, FlatGeobuf, KML, spreadsheet, or PG:...";

}  // namespace

void StudyOptions::declare(OptionList& options, Need basins_need) {
  OptionGroup files = options.group("Files", *this);
  files.add("STATIONS", file(stations), std::string("rain gauges: ") + formats).need =
      Need::required;
  Option& basins_option =
      files.add("BASINS", file(basins), "study areas: polygons in any of these");
  basins_option.need = basins_need;
  basins_option_ = &basins_option;
  declare_fields(options.group("Stations and basins", *this));
  declare_layers(options.group("Stations and basins", *this));
  declare_method(options.group("Method", *this));
}

void StudyOptions::declare_fields(OptionGroup group) {
  group.add("--id", text(id_, "FIELD"), "the station's id; else found by name");
  group.add("--x", text(x_, "FIELD"), "the station's longitude or easting; else found by name");
  group.add("--y", text(y_, "FIELD"), "the station's latitude or northing; else found by name");
  group.add("--skip-unplaced", flag(skip_unplaced_),
            "pass over stations without coordinates, with a warning");
  of_basins_.push_back(&group.add("--basin-id", text(basin_id_, "FIELD"),
                                  "the basin's id; features that share one are one basin"));
  crs_options_.push_back(
      &group.add("--crs", any_text(crs_, "CRS"),
                 "of the stations, where their file names none (EPSG:32633, WKT, PROJ)"));
  crs_options_.push_back(&group.add("--basins-crs", any_text(basins_crs_, "CRS"),
                                    "of the basins, where their file names none"));
  mend_option_ =
      &group.add("--mend", flag(mend_),
                 "mend basins that cross themselves by union, and say what is in dispute");
  of_basins_.push_back(crs_options_.back());
}

void StudyOptions::declare_layers(OptionGroup group) {
  group.add("--stations-layer", text(stations_layer_, "LAYER"),
            "which layer of STATIONS, where the file has several");
  of_basins_.push_back(&group.add("--basins-layer", text(basins_layer_, "LAYER"),
                                  "which layer of BASINS, where the file has several"));
  group.add("--stations-where", text(stations_where_, "SQL"),
            "only the stations that meet this OGR attribute filter");
  of_basins_.push_back(
      &group.add("--basins-where", text(basins_where_, "SQL"), "only the basins that meet it"));
  csv_.declare(group);
  stations_csv_.declare_for(group, "STATIONS");
  for (const Option* option : basins_csv_.declare_for(group, "BASINS"))
    of_basins_.push_back(option);
}

void StudyOptions::declare_method(OptionGroup group) {
  group.add("--metric",
            choice<std::string>(metric_, {{"geodesic", "geodesic"}, {"planar", "planar"}}),
            "what near means: the shortest path on the Earth (default where the CRS is known), or "
            "straight distance in the coordinates");
  plane_option_ = &group.add("--plane", any_text(plane_, "CRS|auto"),
                             "planar, with both files brought into this CRS first; auto: into the "
                             "conformal plane that distorts the study least");
  crs_options_.push_back(plane_option_);
  of_basins_.push_back(&group.add("--allow-far", flag(allow_far_),
                                  "go on where gauges and basins are nowhere near each other"));
  group.add("--tolerance",
            number(tolerance_, {tolerances.low, tolerances.high, "metres from 0.001 to 1e6"}),
            "how far, in metres, a published cell edge may lie from the true one; default 0.1");
  declare_normals(group);
}

void StudyOptions::declare_normals(OptionGroup group) {
  normals_option_ = &group.add(
      "--normals", file(normals_, "RASTER"),
      "long-term means in any unit: a reading counts at a point times the normal there over the "
      "gauge's. A raster that GDAL reads, of one band, or twelve for the calendar months; ground "
      "without normals takes the mean of the rest of what its gauge has. weights has a column "
      "factor "
      "then, or factor_01 to factor_12");
  normal_field_option_ = &group.add(
      "--normal-field", text(normal_field_, "FIELD"),
      "the same from a field of STATIONS and of BASINS, or twelve, FIELD_01 to FIELD_12");
  of_basins_.push_back(normal_field_option_);
  declare_elevations(group);
}

void StudyOptions::declare_elevations(OptionGroup group) {
  elevation_option_ = &group.add(
      "--elevation", file(elevation_, "RASTER"),
      "normals fitted to RAINFALL, which is read once more, by the ground's elevation; those of "
      "calendar months where ten gauges have ten years of each. A gauge's elevation is that of a "
      "field of STATIONS (elev, elevation, z, alt or altitude), else of its pixel. An error where "
      "leaving each gauge out shows that elevation tells too little of rain");
  elevation_field_option_ = &group.add(
      "--elevation-field", text(elevation_field_, "FIELD"),
      "the field of STATIONS with their elevations; without --elevation a field of BASINS, too, "
      "with their mean ones");
}

std::vector<std::string> StudyOptions::files() const {
  std::vector<std::string> all{stations, basins};
  if (has_normal_raster()) all.push_back(normals_);
  if (elevation_option_->is_given()) all.push_back(elevation_);
  return all;
}

void StudyOptions::declare_attributes(OptionList& options) {
  options.group("Output", *this)
      .add("--attributes", flag(attributes), "carry every field of the station onto its cells");
}

void StudyOptions::declare_label(OptionList& options) {
  label_option_ = &options.group("Picture", *this)
                       .add("--label", text(label_, "FIELD|none"),
                            "what the stations are called in the picture; default their ids");
}

void StudyOptions::check() const {
  if (plane_option_->is_given() && metric_ == "geodesic") {
    throw UsageError{"--plane is planar, and --metric says geodesic", "leave one of them out"};
  }
  check_normals();
  if (mend_ && !basins_option_->is_given())
    throw UsageError{mend_option_->name + " mends basins, and there are none", "give BASINS"};
  for (const Option* option : of_basins_) {
    if (!option->is_given() || has_basins()) continue;
    throw UsageError{option->name + " is about basins, and there is no BASINS",
                     "give BASINS, or leave it out"};
  }
}

void StudyOptions::check_normals() const {
  std::vector<std::string> given;
  for (const Option* option : {normals_option_, normal_field_option_}) {
    if (option->is_given()) given.push_back(option->name);
  }
  const Option* const by =
      elevation_option_->is_given() ? elevation_option_ : elevation_field_option_;
  if (by->is_given()) given.push_back(by->name);
  if (given.size() > 1) {
    throw UsageError{given[0] + " and " + given[1] + " both say where normals are",
                     "leave one of them out"};
  }
  if (by == elevation_field_option_ && by->is_given() && !has_basins()) {
    throw UsageError{by->name + " alone is about basins, too, and there is no BASINS",
                     "give BASINS, or --elevation RASTER"};
  }
}

StudyRequest StudyOptions::request() const {
  check_texts();
  StudyRequest request;
  Source& s = request.stations.source;
  s.file = stations;
  s.layer = stations_layer_;
  s.where = stations_where_;
  s.crs = crs_;
  s.csv = stations_csv_.or_else(csv_.said());
  s.csv.numbers = numbers_in({id_, x_, y_});
  s.csv.input = "stations";
  request.stations.id = id_;
  request.stations.x = x_;
  request.stations.y = y_;
  request.stations.skip_unplaced = skip_unplaced_;
  if (labels()) request.stations.label = label_;
  request.stations.attributes = attributes;
  request.stations.normal_field = normal_field_;
  if (fits_normals()) request.stations.elevation_field = elevation_field_;
  if (basins_option_->is_given()) {
    BasinsRequest& b = request.basins.emplace();
    b.source = {basins,         basins_layer_,  basins_where_, basins_crs_,
                "basins_layer", "basins_where", "basins_crs",  basins_csv_.or_else(csv_.said())};
    b.source.csv.input = "basins";
    b.id = basin_id_;
    b.normal_field = normal_field_;
    if (!elevation_option_->is_given() && fits_normals()) b.elevation_field = elevation_field_;
  }
  request.opened = opened;
  request.opened_from = "--with";
  if (!metric_.empty()) request.metric = metric_ == "planar" ? Metric::planar : Metric::geodesic;
  request.plane = plane_;
  request.tolerance = tolerance_;
  request.mend = mend_;
  return request;
}

void StudyOptions::check_texts() const {
  for (const Option* option : crs_options_) {
    if (option->is_given() && option->texts.back().empty())
      throw Error({"", 0, option->name + " is empty", "give a CRS such as EPSG:32633"});
  }
}

}  // namespace thiessen::cli
