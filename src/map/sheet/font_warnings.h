#pragma once

#include "base/error.h"
#include "map/opencv/typesetter.h"

namespace thiessen {

/// Warns of characters that no installed font shows, and gives a notice of those that only a font
/// of bitmaps shows, with the package of a better one.
void warn_of_fonts(const Typesetter& type, Warnings& warnings);

}  // namespace thiessen
