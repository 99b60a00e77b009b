#pragma once

#include <optional>
#include <span>

#include "basin/basin.h"
#include "earth/yardstick.h"

namespace thiessen {

/// The rectangle that holds all places, grown by `margin` percent of its larger side on each side.
///
/// Geodesic: it goes the shorter way round the Earth (eastern longitudes may pass 180) and never
/// beyond the poles; for a single place it is the whole Earth. Where the longitudes leave no gap of
/// 180 degrees, there is no shorter way: if all places stand in one hemisphere, the extent is the
/// cap round its pole down to the farthest of them, its radius in degrees grown by `margin`
/// percent; else it goes all round. A place at a pole has no longitude. Planar: there is none where
/// the grown rectangle has no width or no height.
std::optional<Basin> extent_of(std::span<const Point> places, Metric metric, double margin);

}  // namespace thiessen
