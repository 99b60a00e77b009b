#include "gdal/layers/wkt.h"

#include <ogr_geometry.h>

#include <cstring>
#include <memory>

#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"

namespace thiessen {

std::optional<GeometryRecord> record_of_wkt(const std::string& wkt) {
  if (wkt.find_first_not_of(" \t\r\n") == std::string::npos) return GeometryRecord{};
  const GdalErrors errors;
  const char* rest = wkt.c_str();
  OGRGeometry* parsed = nullptr;
  const OGRErr failed = OGRGeometryFactory::createFromWkt(&rest, nullptr, &parsed);
  const std::unique_ptr<OGRGeometry> geometry(parsed);
  if (failed != OGRERR_NONE || !geometry) return std::nullopt;
  if (rest != nullptr && std::strspn(rest, " \t\r\n") != std::strlen(rest)) return std::nullopt;
  return record_of(geometry.get());
}

}  // namespace thiessen
