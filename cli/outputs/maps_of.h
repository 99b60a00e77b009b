#pragma once

#include <span>
#include <vector>

#include "cli/inputs/inputs.h"
#include "cli/options/blocks/view_options.h"
#include "map/sheet/picture.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The maps of a page: one of the network where there are no steps, else one of each step in its
/// own tessellation. What the first says of how it was made is true of all. Memory: the cells of
/// all maps.
std::vector<Picture> maps_of(const Inputs& inputs, std::span<const GaugeReadings> steps,
                             const StudyOptions& options, const ViewOptions& view,
                             unsigned threads);

}  // namespace thiessen::cli
