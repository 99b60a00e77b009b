#pragma once

#include "base/wording.h"

namespace thiessen {

/// To be called where an exception is being handled: throws an Error in place of what OpenCV
/// throws, and of a lack of memory, for which it gives the hint; all else is thrown on as it is.
[[noreturn]] void throw_drawing_error(const Wording& memory_hint = {});

}  // namespace thiessen
