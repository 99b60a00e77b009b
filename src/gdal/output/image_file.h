#pragma once

#include <vector>

#include "geometry/pixels.h"

namespace thiessen {

/// Encodes pixels as the bytes of a PNG, without loss, or of a JPEG of quality 93, which say
/// nothing of themselves. Throws Error where GDAL cannot, and Interrupted after Ctrl-C.
std::vector<unsigned char> image_file(const Pixels& pixels, ImageFormat format);

}  // namespace thiessen
