#include "report/report_legend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "map/svg/xml_text.h"

namespace thiessen {
namespace {

std::string entry(const std::string& patch, const std::string& text) {
  return "<li><svg aria-hidden=\"true\" viewBox=\"0 0 400 275\">" + patch + "</svg>" +
         xml_text(text) + "</li>\n";
}

/// An entry of a ground; without a colour it is that of cells without a reading.
std::string ground_entry(const std::string& colour, const std::string& text) {
  const std::string fill = colour.empty() ? "" : " fill=\"" + colour + "\"";
  return entry("<rect width=\"400\" height=\"275\"" + fill + "/>", text);
}

/// An entry of dots that are drawn as those of the map.
std::string dot_entry(const std::string& kind, const std::string& text) {
  const std::string dot = "\" d=\"M200 137h0\"/>";
  return entry("<path class=\"halo" + dot + "<path class=\"" + kind + dot, text);
}

/// The range of a class between the texts at its ends. An end may be open: it has no text, or one
/// that begins with a sign.
std::string range_of(const RainfallClasses& classes, std::size_t i, const std::string& unit) {
  const std::string& low = classes.ticks()[i];
  if (i + 1 == classes.ticks().size()) return low + unit;
  const std::string& high = classes.ticks()[i + 1];
  const bool is_open_below = low.empty() || low.starts_with("\u2264");
  const bool is_open_above = high.empty() || high.starts_with("\u2265");
  if (is_open_below && is_open_above) return "any";
  if (is_open_below) return "below " + high + unit;
  return is_open_above ? "from " + low + unit : low + " to " + high + unit;
}

std::string classes_list(const char* id, const char* attributes, const RainfallClasses& classes,
                         const std::string& unit) {
  std::string html = std::string("<ul id=\"") + id + "\"" + attributes + ">\n";
  for (std::size_t i = classes.count(); i-- > 0;)
    html += ground_entry(hexadecimal(classes.class_colour(i)), range_of(classes, i, unit));
  if (classes.has_dry()) html += ground_entry(hexadecimal(classes.colour(0)), "0" + unit);
  return html + "</ul>\n";
}

bool any_is_silent(const Report& report) {
  const std::vector<std::size_t>& silent = report.series->silent_steps();
  return std::any_of(silent.begin(), silent.end(), [](std::size_t steps) { return steps > 0; });
}

std::string signs_list(const Report& report) {
  const std::vector<PictureGauge>& gauges = report.picture->gauges;
  const auto reports = [](const PictureGauge& gauge) { return gauge.reports; };
  std::string html = "<ul>\n";
  if (any_is_silent(report)) html += ground_entry("", "no reading");
  if (std::any_of(gauges.begin(), gauges.end(), reports)) html += dot_entry("gauges", "rain gauge");
  if (!std::all_of(gauges.begin(), gauges.end(), reports))
    html += dot_entry("never", "gauge without any reading");
  return html + "</ul>\n";
}

}  // namespace

std::optional<RainfallClasses> classes_of_steps(const Report& report) {
  if (!report.series->has_readings()) return std::nullopt;
  std::vector<double> all;
  for (const SeriesStretch& stretch : report.series->stretches()) {
    for (const double reading : stretch.readings) {
      if (!std::isnan(reading)) all.push_back(reading);
    }
  }
  return RainfallClasses(std::move(all), report.picture->classes);
}

std::string report_legend(const Report& report, const std::optional<RainfallClasses>& of_steps) {
  const std::string unit = report.unit.empty() ? "" : " " + report.unit;
  std::string html = classes_list("mean-classes", "", classes_of(*report.picture), unit);
  if (of_steps) html += classes_list("step-classes", " hidden", *of_steps, unit);
  return html + signs_list(report);
}

}  // namespace thiessen
