#pragma once

#include <optional>
#include <span>

#include "basin/basin.h"
#include "earth/yardstick.h"

namespace thiessen {

/// The rectangle that holds all places, grown by `margin` percent of its larger side on each side.
///
/// Geodesic: it goes the shorter way round the Earth (eastern longitudes may pass 180) and never
/// beyond the poles; for a single place it is the whole Earth. Planar: there is none where the
/// grown rectangle has no width or no height.
std::optional<Basin> extent_of(std::span<const Point> places, Metric metric, double margin);

}  // namespace thiessen
