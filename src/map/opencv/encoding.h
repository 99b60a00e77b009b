#pragma once

#include <vector>

#include "map/opencv/picture_tags.h"
#include "map/opencv/pixel_canvas.h"

namespace thiessen {

/// The formats of image files in which pixels can be encoded.
enum class PixelFormat { png, jpeg };

/// Encodes the canvas as the bytes of an image file that says the tags of itself, and its density
/// where that is above 0. Throws Error where encoding fails.
std::vector<unsigned char> encoded(PixelCanvas& canvas, PixelFormat format, const PictureTags& tags,
                                   int dots_to_the_inch = 0);

}  // namespace thiessen
