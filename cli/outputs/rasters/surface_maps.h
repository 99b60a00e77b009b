#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/inputs/inputs.h"
#include "cli/options/blocks/isohyet_options.h"
#include "gdal/output/isohyet_lines.h"
#include "geometry/polygon.h"
#include "map/sheet/picture.h"
#include "rainfall/methods/rain_surface.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// What stands over a picture of the surface, or of cells with isohyets, where nothing else is
/// said.
std::string title_of(const IsohyetOptions& options);

/// The isohyets in the shapes that a picture of the readings' surface has, of the usual width and
/// with classes of its own choice: where these meet. `resolution` is the pixel of the raster on
/// which they are drawn; 0: that behind the picture. None where no gauge reports.
std::vector<Isohyet> pictured_isohyets(const Inputs& inputs, const GaugeReadings& readings,
                                       SurfaceMethod method, double resolution,
                                       std::span<const MultiPolygon> shapes, unsigned threads);

/// Puts the surface that the options ask for, and isohyets, into the maps, each of which shows one
/// of the steps. Classes and levels are those of all maps together. A step in which no gauge
/// reports has neither. Cost: the surface at 1,000 to 2,000 pixels of the study area's longer side,
/// for each map, and twice where isohyets are drawn over it.
void add_surfaces(const Inputs& inputs, std::span<const GaugeReadings> steps,
                  const IsohyetOptions& options, std::vector<Picture>& maps, unsigned threads);

}  // namespace thiessen::cli
