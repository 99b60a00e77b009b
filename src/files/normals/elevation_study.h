#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/study_files.h"
#include "rainfall/leaving_out/left_out_readings.h"
#include "rainfall/normals/calendar_normals.h"
#include "rainfall/normals/normal_field.h"
#include "study/study.h"

namespace thiessen {

/// From what normals are fitted.
struct ElevationRequest {
  /// The raster of the ground's elevations; empty: basins have a field of their mean ones.
  std::string raster;
  bool is_field_named = false;  ///< whether the stations' field was named
  bool may_have_months = true;  ///< whether calendar months may have normals of their own
  std::string rainfall;         ///< the readings' name in messages
  unsigned threads = 1;
};

/// Normals that are fitted by elevation, and the elevations of the stations.
struct ElevationStudy {
  std::shared_ptr<const NormalField> normals;
  std::vector<double> elevations;
};

/// Fits the normals of a study to those of the gauges by elevation: see ElevationFit. They are of
/// the calendar months where ten places have ten years of each and the fit stands the test, else of
/// the year. The study must outlive them.
///
/// Says how far off ln N of a gauge is that is left out. Throws Error where fewer than ten places
/// have rain, all gauges lie at one height, or the fit does not tell a gauge that is left out so
/// much better than the nearest gauge does as ElevationFit::is_better_than_nearest wants it; and
/// where elevations are missing or in two units (see elevations_of_gauges).
ElevationStudy normals_by_elevation(const ElevationRequest& request, const Study& study,
                                    const StudyFiles& files, const CalendarNormals& gauges,
                                    Warnings& warnings);

/// What is said of the readings of gauges that were left out: how far off the nearest gauge's are,
/// with the normals and without, in all and by bands of elevation. `unit` may be empty.
std::string left_out_text(const LeftOutReadings& readings, const std::string& unit);

}  // namespace thiessen
