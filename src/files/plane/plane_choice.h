#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "earth/plane/plane_fit.h"
#include "files/places/stations_file.h"
#include "gdal/crs/crs.h"

namespace thiessen {

/// The value of StudyRequest::plane that asks for a plane made for the study.
inline constexpr const char* automatic_plane = "auto";

/// A share in per cent with two digits that tell: `0.042 %`.
std::string percent_text(double share);

/// Makes the plane for a study of gauges and basins, which may be none, each in its own CRS, and
/// warns which it is, with the scale error. The stations have a CRS; `degrees` is WGS 84 over the
/// study's area. Throws Error where lengths would be off by more than largest_scale_error in the
/// best of planes, and where nothing lies in the area of its projection. Cost: a projection a
/// station and a vertex.
StudyPlane choose_plane(const StationsFile& stations, std::span<const MultiPolygon> basins,
                        const std::optional<Crs>& basins_crs, const Crs& degrees,
                        Warnings& warnings);

}  // namespace thiessen
