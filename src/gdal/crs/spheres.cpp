#include "gdal/crs/spheres.h"

#include "gdal/crs/proj_objects.h"
#include "gdal/gdal_errors.h"

namespace thiessen {

bool is_on_sphere(const OGRSpatialReference& system) {
  return system.GetSemiMinor() == system.GetSemiMajor();
}

OGRSpatialReference without_shift(const OGRSpatialReference& system, const std::string& wkt) {
  const ProjContext context = quiet_context();
  ProjObject crs(proj_create(context.get(), wkt.c_str()));
  while (crs && proj_get_type(crs.get()) == PJ_TYPE_BOUND_CRS)
    crs.reset(proj_get_source_crs(context.get(), crs.get()));
  const char* text = crs ? proj_as_wkt(context.get(), crs.get(), PJ_WKT2_2019, nullptr) : nullptr;
  const GdalErrors errors;
  OGRSpatialReference bare;
  return text != nullptr && bare.importFromWkt(text) == OGRERR_NONE ? bare : system;
}

}  // namespace thiessen
