#pragma once

namespace thiessen {

/// The version of GeographicLib that this was compiled with, such as "2.1.2": the library itself
/// cannot be asked.
const char* geographiclib_version();

}  // namespace thiessen
