#pragma once

#include <optional>
#include <span>

#include "basin/basin.h"
#include "earth/yardstick.h"

namespace thiessen {

/// The rectangle that holds the places, grown by `margin` percent of its larger side on each side.
/// Geodesic: the shorter way round the Earth (eastern longitudes may pass 180), never beyond the
/// poles; the whole Earth where there is one place. Planar: nothing where the places have no
/// extent.
std::optional<Basin> extent_of(std::span<const Point> places, Metric metric, double margin);

}  // namespace thiessen
