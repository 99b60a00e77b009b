#pragma once

#include <string>

#include "gdal/crs/crs.h"

namespace thiessen {

// The rules for coordinates where no authority knows how one datum lies in another. On an ellipsoid
// such as Bessel's the coordinates may be hundreds of metres off, so they are refused. Reference
// frames on the ellipsoids of WGS 84 and GRS 1980 lie within two metres or so of each other. For
// spheres see spheres.h.

/// Whether the CRS is on a sphere.
bool on_sphere(const Crs& crs);

/// Whether longitudes and latitudes stay as they are where no operation is known: among spheres and
/// the ellipsoids of WGS 84 and GRS 1980, and between two CRSs that name one ellipsoid and no
/// datum.
bool may_be_taken_over(const Crs& from, const Crs& to);

/// Throws Error, which says that PROJ lacks a grid for the transformation.
[[noreturn]] void fail_for_grid(const Crs& from, const Crs& to, const std::string& grid);
/// Throws Error, which says that PROJ lacks the projection.
[[noreturn]] void fail_for_projection(const Crs& from, const Crs& to);
/// Throws Error, which says that no transformation of datum is known between the CRSs.
[[noreturn]] void fail_for_datum(const Crs& from, const Crs& to);

}  // namespace thiessen
