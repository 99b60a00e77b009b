#pragma once

namespace thiessen {

/// The version of the library and the program, such as "0.1.0".
const char* version();

}  // namespace thiessen
