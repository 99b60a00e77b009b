#include "cli/outputs/maps_of.h"

#include <string>

#include "cli/outputs/cell_features.h"
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

}  // namespace

std::vector<Picture> maps_of(const Inputs& inputs, std::span<const GaugeReadings> steps,
                             const StudyOptions& options, const ViewOptions& view,
                             unsigned threads) {
  std::vector<Picture> maps;
  if (steps.empty()) {
    maps.push_back(picture_of(inputs, cells_of_network(inputs, threads), nullptr, options, view));
    return maps;
  }
  for (const GaugeReadings& step : steps) {
    maps.push_back(picture_of(inputs, cells_of(inputs, &step, threads), &step, options, view));
  }
  Provenance made_by = provenance_of(inputs, options, &steps.front(), view.units);
  made_by.rainfall = labels_of(steps);
  maps.front().tags = items_of(made_by);
  return maps;
}

}  // namespace thiessen::cli
