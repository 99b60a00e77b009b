#pragma once

#include <string>

namespace thiessen {

/// The version of the OpenCV that runs, such as "4.6.0".
std::string opencv_version();

}  // namespace thiessen
