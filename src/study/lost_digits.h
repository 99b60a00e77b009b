#pragma once

#include "base/error.h"
#include "study/study_parts.h"

namespace thiessen {

/// Which share of a basin's extent the rounding of coordinates may be: more is worth a warning, and
/// still more makes weights that nobody wants.
inline constexpr double share_lost_in_silence = 1e-7;
inline constexpr double share_lost_at_most = 1e-5;

/// Looks how many digits of the coordinates of a plane tell places within a basin apart. Corners of
/// cells are doubles, too: far from the plane's origin they are rounded to so much that small cells
/// are moved, or lost. Throws Error where that is more than share_lost_at_most of a basin's extent,
/// and warns of the worst basin where it is more than share_lost_in_silence.
/// Cost: linear in the vertices.
void judge_digits(const StudyParts& parts, Warnings& warnings);

}  // namespace thiessen
