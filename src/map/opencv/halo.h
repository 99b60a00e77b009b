#pragma once

#include "map/ink/set_text.h"

namespace thiessen {

/// The coverage grown by `radius` pixels on every side, as a halo behind text.
Coverage halo(const Coverage& coverage, int radius);

}  // namespace thiessen
