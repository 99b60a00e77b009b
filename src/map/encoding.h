#pragma once

#include <vector>

#include "map/canvas.h"
#include "map/picture.h"

namespace thiessen {

/// The bytes of an image file. Throws Error where encoding fails.
std::vector<unsigned char> encoded(Canvas& canvas, PictureFormat format);

}  // namespace thiessen
