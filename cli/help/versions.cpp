#include "cli/help/versions.h"

#include "base/version.h"
#include "cli/help/commit.h"
#include "earth/geographiclib_version.h"
#include "gdal/library_versions.h"
#include "map/opencv/opencv_version.h"

namespace thiessen::cli {

std::string versions() {
  return std::string("thiessen ") + version() + "\ncommit " + commit() + "\nGDAL " +
         gdal_version() + "\nPROJ " + proj_version() + "\nGeographicLib " +
         geographiclib_version() + "\nOpenCV " + opencv_version() + "\n";
}

}  // namespace thiessen::cli
