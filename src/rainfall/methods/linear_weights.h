#pragma once

#include <array>

#include "rainfall/methods/natural_weights.h"

namespace thiessen {

/// The weights of the corners of a Delaunay triangle of gauges at a point of it, with which values
/// are linear in the triangle. They are not negative, and not all 0; they add up to 1 but for a
/// factor.
///
/// In the plane `v` is the vertex whose triangle holds the point. On the Earth triangles are the
/// flat ones between three gauges, as their points are seen from the middle of the conformal
/// sphere, and v is where the search for the point's begins. Requires gauges that span the plane of
/// their chart, and a vertex without the infinite point, but where that is a gauge.
std::array<NaturalWeight, 3> linear_weights(const NaturalWeights& gauges, VertexId v,
                                            const ChartPoint& point);

}  // namespace thiessen
