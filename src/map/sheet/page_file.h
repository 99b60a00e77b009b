#pragma once

#include <functional>
#include <string>

#include "geometry/pixels.h"
#include "map/ink/canvas.h"
#include "map/sheet/page.h"
#include "map/sheet/picture.h"

namespace thiessen {

/// The bytes of a file whose page `draw` draws. What the file says of itself is the
/// picture's. An SVG needs no encoder.
std::string page_file(const Page& page, const Picture& picture, PictureFormat format,
                      ImageEncoder encoder, const std::function<void(Canvas&)>& draw);

/// Draws the title and the subtitle over a page.
void draw_head(Canvas& canvas, const Page& page);

}  // namespace thiessen
