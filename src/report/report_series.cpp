#include "report/report_series.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "map/sheet/rainfall_classes.h"
#include "map/svg/xml_text.h"
#include "rainfall/gaps/gap_policies.h"
#include "text/json_text.h"

namespace thiessen {
namespace {

constexpr int most_decimals = 6;

void append_key(std::string& json, const char* key) {
  json += json.ends_with('{') ? "\"" : ",\"";
  json += key;
  json += "\":";
}

void append_text(std::string& json, const char* key, std::string_view text) {
  append_key(json, key);
  append_json_string(json, text);
}

void append_count(std::string& json, const char* key, std::size_t count) {
  append_key(json, key);
  json += std::to_string(count);
}

/// A list, of whose items `append(i)` adds one.
template <typename Append>
void append_list(std::string& json, std::size_t count, const Append& append) {
  json += '[';
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) json += ',';
    append(i);
  }
  json += ']';
}

template <typename Append>
void append_list(std::string& json, const char* key, std::size_t count, const Append& append) {
  append_key(json, key);
  append_list(json, count, append);
}

/// The fewest decimals that hold all values to five digits of the largest.
template <typename Visit>
int decimals_of(const Visit& for_each_value) {
  double largest = 0;
  for_each_value([&](double value) { largest = std::max(largest, std::abs(value)); });
  if (largest == 0) return 0;
  const int digits = 4 - static_cast<int>(std::floor(std::log10(largest)));
  const int enough = std::clamp(digits, 0, most_decimals);
  int decimals = 0;
  for_each_value([&](double value) {
    while (decimals < enough) {
      const double scaled = value * std::pow(10, decimals);
      if (std::abs(scaled - std::round(scaled)) <= 1e-9 * std::abs(scaled)) break;
      ++decimals;
    }
  });
  return decimals;
}

/// Whole numbers with commas between them; nothing stands where there is no value.
class Scaled {
 public:
  explicit Scaled(int decimals) : factor_(std::pow(10, decimals)) {}

  void append(std::string& json, double value) const {
    if (!std::isnan(value)) append_fixed(json, value * factor_, 0);
  }
  template <typename Value>
  void append_row(std::string& json, std::size_t count, const Value& value) const {
    json += '"';
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) json += ',';
      append(json, value(i));
    }
    json += '"';
  }

 private:
  double factor_;
};

/// The classes of the cells' rainfall: their bounds and colours.
void append_classes(std::string& json, const char* key, const RainfallClasses& classes) {
  append_key(json, key);
  json += '{';
  append_list(json, "bounds", classes.bounds().size(),
              [&](std::size_t i) { append_shortest(json, classes.bounds()[i]); });
  append_list(json, "colours", classes.count(), [&](std::size_t i) {
    append_json_string(json, hexadecimal(classes.class_colour(i)));
  });
  if (classes.has_dry()) append_text(json, "dry", hexadecimal(classes.colour(0)));
  json += '}';
}

template <typename Visit>
void for_each_reading(const ThinnedSeries& series, const Visit& visit) {
  for (const SeriesStretch& stretch : series.stretches()) {
    for (const double reading : stretch.readings) {
      if (!std::isnan(reading)) visit(reading);
    }
  }
}

template <typename Visit>
void for_each_areal_value(const ThinnedSeries& series, const Visit& visit) {
  for (const SeriesStretch& stretch : series.stretches()) {
    for (const SeriesStretch::OfBasin& basin : stretch.basins) {
      if (basin.values == 0) continue;
      visit(basin.least);
      visit(basin.largest);
    }
  }
}

void append_readings(std::string& json, const Report& report) {
  const ThinnedSeries& series = *report.series;
  const int decimals = decimals_of([&](const auto& visit) { for_each_reading(series, visit); });
  append_count(json, "readingDecimals", static_cast<std::size_t>(decimals));
  const Scaled scaled(decimals);
  const std::vector<SeriesStretch>& stretches = series.stretches();
  append_list(json, "readings", stretches.size(), [&](std::size_t i) {
    const std::vector<double>& readings = stretches[i].readings;
    scaled.append_row(json, readings.size(), [&](std::size_t g) { return readings[g]; });
  });
}

/// By basin: its largest value in each stretch; where stretches hold several steps, also the least
/// and the sum, and how many steps have a value.
void append_areal_values(std::string& json, const Report& report) {
  const ThinnedSeries& series = *report.series;
  const std::vector<SeriesStretch>& stretches = series.stretches();
  const int decimals = decimals_of([&](const auto& visit) { for_each_areal_value(series, visit); });
  append_count(json, "decimals", static_cast<std::size_t>(decimals));
  const Scaled scaled(decimals);
  const auto append = [&](const char* key, const auto& value_of) {
    append_list(json, key, report.basins.size(), [&](std::size_t b) {
      scaled.append_row(json, stretches.size(),
                        [&](std::size_t i) { return value_of(stretches[i].basins[b]); });
    });
  };
  append("largest", [](const SeriesStretch::OfBasin& basin) { return basin.largest; });
  if (series.steps_in_a_stretch() == 1) return;
  append("least", [](const SeriesStretch::OfBasin& basin) { return basin.least; });
  append("sums", [](const SeriesStretch::OfBasin& basin) { return basin.sum; });
}

void append_basins(std::string& json, const Report& report) {
  append_list(json, "basins", report.basins.size(), [&](std::size_t b) {
    const BasinSummary& basin = report.basins[b];
    std::size_t values = 0;
    for (const SeriesStretch& stretch : report.series->stretches())
      values += stretch.basins[b].values;
    json += '{';
    append_text(json, "name", basin.basin);
    append_count(json, "values", values);
    if (basin.mean) {
      append_key(json, "mean");
      append_shortest(json, *basin.mean);
    }
    if (basin.standard_error) {
      append_key(json, "error");
      append_shortest(json, *basin.standard_error);
    }
    json += '}';
  });
}

/// The cells in the order of the map's paths: gauge, basin, weight, mean rainfall.
void append_cells(std::string& json, const Report& report) {
  std::size_t at = 0;  // both lists are by basin, and by station within it
  const Picture& picture = *report.picture;
  append_list(json, "cells", picture.cells.size(), [&](std::size_t i) {
    const PictureCell& cell = picture.cells[i];
    const std::string& station = picture.gauges[cell.gauge].station;
    const std::string& basin = report.basins[cell.basin].basin;
    const auto is_of_cell = [&](const WeightRow& weight) {
      return weight.station == station && weight.basin == basin;
    };
    for (std::size_t tried = 0; tried < report.weights.size() && !is_of_cell(report.weights[at]);
         ++tried)
      at = (at + 1) % report.weights.size();
    const bool weighs = at < report.weights.size() && is_of_cell(report.weights[at]);
    json += '[' + std::to_string(cell.gauge) + ',' + std::to_string(cell.basin) + ',';
    json += significant_text(weighs ? report.weights[at].weight : 0, 4);
    json += ',';
    json += std::isnan(cell.rainfall) ? "null" : significant_text(cell.rainfall, 5);
    json += ']';
  });
}

void append_gauges(std::string& json, const Report& report) {
  append_list(json, "gauges", report.network,
              [&](std::size_t i) { append_json_string(json, report.picture->gauges[i].station); });
  append_list(json, "places", report.places.size(),
              [&](std::size_t i) { json += std::to_string(report.places[i]); });
}

}  // namespace

std::string report_json(const Report& report, const std::optional<RainfallClasses>& of_steps) {
  const std::vector<SeriesStretch>& stretches = report.series->stretches();
  std::string json = "{";
  append_text(json, "unit", report.unit);
  append_text(json, "gaps", name_of(report.gaps));
  append_count(json, "steps", report.series->steps());
  append_count(json, "length", report.series->steps_in_a_stretch());
  append_list(json, "times", stretches.size(),
              [&](std::size_t i) { append_json_string(json, stretches[i].time); });
  if (report.series->steps_in_a_stretch() > 1) {
    append_list(json, "begins", stretches.size(),
                [&](std::size_t i) { append_json_string(json, stretches[i].begin); });
  }
  append_classes(json, "meanClasses", classes_of(*report.picture));
  append_gauges(json, report);
  append_basins(json, report);
  append_cells(json, report);
  append_areal_values(json, report);
  if (of_steps) {
    append_classes(json, "classes", *of_steps);
    append_readings(json, report);
  }
  return json + "}";
}

std::string thinning_text(const Report& report) {
  const ThinnedSeries& series = *report.series;
  std::string text;
  if (series.steps_in_a_stretch() > 1) {
    text += "Thinned for the screen: of " + std::to_string(series.steps()) + " time steps each " +
            std::to_string(series.steps_in_a_stretch()) +
            " are shown as one, with the largest and the least value of every basin kept; " +
            (series.has_readings() ? "the map shows the wettest of them. " : "") +
            (report.has_totals ? "rain.csv has totals over periods, not the steps. "
                               : "rain.csv has all steps. ");
  }
  if (!series.has_readings()) {
    text +=
        "The readings by gauge are more than a page can hold and are left out: the map shows the "
        "means over all steps.";
  }
  return xml_text(text);
}

}  // namespace thiessen
