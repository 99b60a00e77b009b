#include "cli/outputs/picture_of.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "cli/outputs/provenance_of.h"
#include "gdal/crs/north.h"
#include "rainfall/series/step_length.h"

namespace thiessen::cli {

namespace {

/// What the picture calls a station: by the field that was asked for, where it says anything.
std::string label_of(const Station& station, const StudyFiles& study, const StudyOptions& options) {
  if (!options.labels()) return {};
  const auto found = study.labels.find(station.id);
  return found == study.labels.end() ? station.id : found->second;
}

/// The unit of a value that fell within a step: "mm per hour". Units that are no depth of water may
/// say a time of their own, and stay as they are.
std::string unit_of(const std::string& units, const GaugeReadings* readings) {
  constexpr std::array<std::string_view, 6> depths{"mm", "cm", "m", "in", "inch", "inches"};
  const bool is_depth = std::find(depths.begin(), depths.end(), units) != depths.end();
  if (!is_depth || readings == nullptr || !readings->step) return units;
  const std::string step = text_of(*readings->step);
  return units + " per " + (step.starts_with("1 ") ? step.substr(2) : step);
}

}  // namespace

Picture picture_of(const Inputs& inputs, const std::vector<std::vector<StationCell>>& cells,
                   const GaugeReadings* readings, const StudyOptions& options,
                   const ViewOptions& view) {
  const StudyFiles& study = inputs.study();
  Picture picture;
  picture.geographic = study.metric == Metric::geodesic || (study.crs && study.crs->geographic());
  picture.metres_per_unit =
      study.metres_per_unit.value_or(std::numeric_limits<double>::quiet_NaN());
  picture.north_is_up =
      picture.geographic || !study.crs || north_is_up(*study.crs, inputs.weighing().frame());
  picture.has_basins = inputs.has_basins();
  picture.by_rainfall = readings != nullptr;
  picture.classes = view.colours.rule;
  picture.title = !view.title.empty()   ? view.title
                  : readings != nullptr ? "Rainfall by Thiessen cells"
                                        : "Thiessen cells";
  picture.subtitle = readings != nullptr ? readings->label : "";
  picture.units = unit_of(view.units, readings);
  picture.tags = items_of(provenance_of(inputs, options, readings, view.units));
  picture.width = view.width();
  picture.height = view.height();
  picture.dots_to_the_inch = view.dots_to_the_inch();
  if (view.size.millimetres)
    picture.paper = {static_cast<double>(view.size.width), static_cast<double>(view.size.height)};
  const std::vector<Station>& stations = inputs.network().stations();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const bool reports = readings == nullptr || !std::isnan(readings->readings[i]);
    const std::string& id = stations[i].id;
    picture.gauges.push_back(
        {stations[i].position, label_of(stations[i], study, options), reports, id});
  }
  for (const Station& station : inputs.never_reporting()) {
    picture.gauges.push_back(
        {station.position, label_of(station, study, options), false, station.id});
  }
  for (std::size_t b = 0; b < cells.size(); ++b) {
    for (const StationCell& cell : cells[b]) {
      const double rainfall = readings == nullptr
                                  ? std::numeric_limits<double>::quiet_NaN()
                                  : cell.factor * readings->readings[index(cell.station)];
      picture.cells.push_back({cell.shape, index(cell.station), rainfall, b});
    }
    const std::string name = inputs.has_basins() ? inputs.basins()[b].id : "";
    picture.basins.push_back({name, inputs.basins()[b].shape});
  }
  return picture;
}

}  // namespace thiessen::cli
