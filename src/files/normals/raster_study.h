#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "files/study_files.h"
#include "rainfall/normals/normal_field.h"
#include "study/study.h"

namespace thiessen {

/// Reads the normals of a study from a raster that GDAL reads, in its own CRS, where the basins lie
/// and at the gauges. It has one band, or twelve for the calendar months. Warns of basins that it
/// does not cover whole, with the share. Throws Error where a gauge or a basin has no normals, or
/// some that are not above 0.
///
/// Pixels are measured as the study measures areas: on the ellipsoid, or in its plane. A raster in
/// degrees is measured exactly; of other projections a pixel's area is the Earth's, and parts of it
/// have its shares in the projection. A raster without a CRS has that of the basins, with a
/// warning. Cost: some 20 nanoseconds a pixel of the basins' boxes and a band, beside GDAL's own.
std::shared_ptr<const NormalField> normals_of_raster(const std::string& file, const Study& study,
                                                     const StudyFiles& files, Warnings& warnings);

}  // namespace thiessen
