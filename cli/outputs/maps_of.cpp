#include "cli/outputs/maps_of.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "cli/outputs/picture_of.h"
#include "cli/outputs/provenance_of.h"

namespace thiessen::cli {
namespace {

/// What the rainfall of all maps is.
std::string labels_of(std::span<const GaugeReadings> steps) {
  std::string labels;
  for (const GaugeReadings& step : steps) labels += (labels.empty() ? "" : ", ") + step.label;
  return labels;
}

/// How far, in metres, a cell's edge may be drawn from the true one without being seen: a twentieth
/// of a pixel, as if the map took all of the page. Of a plane it plays no part.
double unseen_in(const Inputs& inputs, const ViewOptions& view) {
  constexpr double metres_in_degree = 111'320;
  constexpr double share_of_pixel = 0.05;
  const Box& frame = inputs.weighing().frame();
  const double nearest_to_equator = frame.low.y < 0 && frame.high.y > 0
                                        ? 0
                                        : std::min(std::abs(frame.low.y), std::abs(frame.high.y));
  const double width = frame.width() * std::cos(nearest_to_equator * std::numbers::pi / 180);
  const double pixels = std::max(view.width(), view.height());
  const double pixel = metres_in_degree * std::max(width, frame.height()) / pixels;
  return std::max(Yardstick::measuring_tolerance, share_of_pixel * pixel);
}

}  // namespace

std::vector<Picture> maps_of(const Inputs& inputs, std::span<const GaugeReadings> steps,
                             const StudyOptions& options, const ViewOptions& view,
                             unsigned threads) {
  const double tolerance = unseen_in(inputs, view);
  const auto cells_of = [&](const ReportingStations& reports, const NormalMonth& month) {
    return inputs.weighing().pictured_cells(reports, tolerance, threads, month);
  };
  std::vector<Picture> maps;
  if (steps.empty()) {
    maps.push_back(picture_of(inputs, cells_of(inputs.all_report(), {}), nullptr, options, view));
    return maps;
  }
  for (const GaugeReadings& step : steps) {
    maps.push_back(picture_of(inputs, cells_of(step.reports(), step.month), &step, options, view));
  }
  Provenance made_by = provenance_of(inputs, options, &steps.front(), view.units);
  made_by.rainfall = labels_of(steps);
  maps.front().tags = items_of(made_by);
  return maps;
}

}  // namespace thiessen::cli
