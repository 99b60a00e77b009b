#pragma once

#include "base/wording.h"

namespace thiessen {

/// Rethrows the exception that is being handled. What OpenCV throws becomes an Error, and so does a
/// lack of memory, with the given hint; any other exception is thrown on as it is. To be called
/// inside a handler only.
[[noreturn]] void throw_drawing_error(const Wording& memory_hint = {});

}  // namespace thiessen
