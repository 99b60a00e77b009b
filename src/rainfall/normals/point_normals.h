#pragma once

#include <cstddef>
#include <vector>

#include "geometry/point.h"
#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// The normals at the points of a basin, relative to that of the first station: for each of
/// months_of in turn, one for each point. A point without a normal has the mean of the basin. Empty
/// without normals.
std::vector<std::vector<double>> point_normals(const NormalField* normals, std::size_t basin,
                                               const std::vector<Point>& points);

}  // namespace thiessen
