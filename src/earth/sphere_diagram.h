#pragma once

#include <span>

#include "tessellation/diagram.h"

namespace thiessen {

/// The Thiessen cells of `places` (longitude and latitude in degrees) on the conformal sphere,
/// drawn in longitude and latitude as far as they come near `frame`. Cell edges, great circles of
/// that sphere, are subdivided until their chords are within `tolerance` metres of them. The
/// tessellation runs in a stereographic chart whose pole is the first place by coordinates and
/// stands for the point at infinity, so there is no hull and no outside: see StereographicChart.
/// Requires at least one place, different ones, longitudes within 360 degrees of the frame's, and a
/// frame no wider than 360 degrees. Accuracy: see on_sphere. Cost: n log n for n places, and in
/// proportion to the chords, whose number grows with the square root of the edges' length over the
/// tolerance.
Diagram sphere_diagram(std::span<const Point> places, const Box& frame, double tolerance);

}  // namespace thiessen
