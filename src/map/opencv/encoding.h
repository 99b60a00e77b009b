#pragma once

#include <vector>

#include "map/ink/canvas.h"

namespace thiessen {

/// The image files that a canvas is encoded as.
enum class PictureFormat { png, jpeg };

/// The bytes of an image file. Throws Error where encoding fails.
std::vector<unsigned char> encoded(Canvas& canvas, PictureFormat format);

}  // namespace thiessen
