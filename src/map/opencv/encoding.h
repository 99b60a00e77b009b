#pragma once

#include <vector>

#include "geometry/pixels.h"
#include "map/opencv/picture_tags.h"
#include "map/opencv/pixel_canvas.h"

namespace thiessen {

/// Has the canvas encoded as the bytes of an image file that says the tags of itself, and its
/// density where that is above 0. Throws what the encoder throws.
std::vector<unsigned char> encoded(PixelCanvas& canvas, ImageFormat format, ImageEncoder encoder,
                                   const PictureTags& tags, int dots_to_the_inch = 0);

}  // namespace thiessen
