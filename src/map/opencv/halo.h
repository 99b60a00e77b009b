#pragma once

#include "map/ink/canvas.h"

namespace thiessen {

/// The coverage grown by `radius` pixels on every side: a halo.
Coverage halo(const Coverage& coverage, int radius);

}  // namespace thiessen
