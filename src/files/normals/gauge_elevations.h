#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "files/normals/raster_ground.h"
#include "files/study_files.h"
#include "study/study.h"

namespace thiessen {

/// The elevations of the gauges, in the unit of the ground's.
struct GaugeElevations {
  std::vector<double> of_stations;
  /// By what the raster's values are multiplied; 1 where there is none.
  double raster_scale = 1;
};

/// Finds the elevation of each gauge: of the stations' field, which was read with them (see
/// StationsRequest::elevation_field), or of the raster's pixel that holds it; stations at one place
/// have the mean of those that are known. `ground` may be null. `is_field_named` is whether the
/// user named the field.
///
/// A raster whose unit is feet is brought to metres unless the stations are in feet, too. What was
/// taken from where is said in notices. Throws Error with all stations whose elevation nothing
/// tells, and where those of the stations are in feet and the raster's in metres, or the other way
/// round.
GaugeElevations elevations_of_gauges(const Study& study, const StudyFiles& files,
                                     const RasterGround* ground, bool is_field_named,
                                     Warnings& warnings);

}  // namespace thiessen
