#include "cli/outputs/provenance_of.h"

#include "base/version.h"

namespace thiessen::cli {

Provenance provenance_of(const Inputs& inputs, const StudyOptions& options,
                         const GaugeReadings* readings, const std::string& unit) {
  const StudyFiles& study = inputs.study();
  Provenance made_by;
  made_by.software = std::string("thiessen ") + version();
  made_by.metric = study.metric == Metric::geodesic ? "geodesic" : "planar";
  if (study.plane) {
    made_by.plane = study.plane->plane.proj_text();
  } else if (study.metric == Metric::planar && study.crs) {
    made_by.plane = study.crs->name();
  }
  made_by.tolerance = options.tolerance();
  made_by.method = "thiessen";
  if (const NormalField* const normals = inputs.weighing().normals(); normals != nullptr) {
    made_by.normals = options.fits_normals()        ? "fitted by elevation"
                      : options.has_normal_raster() ? "raster"
                                                    : "fields";
    if (normals->months() > 1) made_by.normals += " of calendar months";
  }
  if (readings == nullptr) return made_by;
  made_by.unit = unit;
  made_by.rainfall = readings->label;
  return made_by;
}

}  // namespace thiessen::cli
