#pragma once

#include <string>

#include "gdal/crs.h"

namespace thiessen {

// What becomes of coordinates where no authority knows how one datum lies in another. On an
// ellipsoid such as Bessel's they may be hundreds of metres off, and are refused. Reference frames
// on the ellipsoids of WGS 84 and GRS 1980 lie within two metres or so of each other. A sphere is a
// model's Earth (WRF, MODIS, EASE-Grid): what its longitudes and latitudes come from are those of
// WGS 84, unchanged.

bool on_sphere(const Crs& crs);

/// Whether longitudes and latitudes stay as they are where no operation is known: among spheres and
/// the ellipsoids of WGS 84 and GRS 1980, and between two CRSs that name one ellipsoid and no
/// datum.
bool may_be_taken_over(const Crs& from, const Crs& to);

[[noreturn]] void fail_for_grid(const Crs& from, const Crs& to, const std::string& grid);
[[noreturn]] void fail_for_projection(const Crs& from, const Crs& to);
[[noreturn]] void fail_for_datum(const Crs& from, const Crs& to);

}  // namespace thiessen
