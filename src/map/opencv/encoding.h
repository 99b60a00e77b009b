#pragma once

#include <vector>

#include "map/ink/canvas.h"
#include "map/opencv/picture_tags.h"

namespace thiessen {

/// The formats of image files in which a canvas can be encoded.
enum class PictureFormat { png, jpeg };

/// Encodes the canvas as the bytes of an image file that says the tags of itself. Throws Error
/// where encoding fails.
std::vector<unsigned char> encoded(Canvas& canvas, PictureFormat format, const PictureTags& tags);

}  // namespace thiessen
