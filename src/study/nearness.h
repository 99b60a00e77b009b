#pragma once

#include <vector>

#include "base/error.h"
#include "rainfall/network/network.h"
#include "study/nearest_gauges.h"
#include "study/study_parts.h"

namespace thiessen {

/// How far gauges and basins may be from each other before it is a fault.
/// - Nowhere near each other: the least distance between a gauge and a basin is over so many times
/// the longer diagonal of the two extents and, where the unit is known, over so many metres.
/// - A basin is far from its gauges where the nearest one is farther than so many times the median
/// distance between neighbouring gauges (or, of a single place of gauges, so many times the basin's
/// diagonal) and than the basin's own diagonal.
inline constexpr double diagonals_apart_at_most = 5;
inline constexpr double metres_apart_at_least = 300e3;
inline constexpr double spacings_apart_at_most = 5;

/// Judges how far the nearest gauge of every basin is.
/// Throws Error where gauges and basins are nowhere near each other and that is not allowed, with
/// both extents and the likely cause, if the parts' far_causes have one without which they would
/// meet. Warns of it where it is allowed, and of basins far from their gauges, with the distances
/// and, where that is all of them, the likely cause.
/// Cost: that of a tree of the gauges, and of nearest_gauges for basins that have no gauge within
/// their own diagonal; where a basin is farther from its gauges than its own diagonal
/// also that of spacing_of.
void judge_nearness(const StudyParts& parts, const Network& network, bool allow_far,
                    Warnings& warnings);

}  // namespace thiessen
