#pragma once

#include <vector>

#include "map/ink/canvas.h"

namespace thiessen {

/// The formats of image files in which a canvas can be encoded.
enum class PictureFormat { png, jpeg };

/// Encodes the canvas as the bytes of an image file. Throws Error where encoding fails.
std::vector<unsigned char> encoded(Canvas& canvas, PictureFormat format);

}  // namespace thiessen
