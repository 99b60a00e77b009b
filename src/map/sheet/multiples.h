#pragma once

#include <span>
#include <string>

#include "base/error.h"
#include "map/sheet/picture.h"

namespace thiessen {

/// Draws several maps of one study side by side on one page, and encodes it as encode_picture does.
/// Each is headed by its subtitle; classes and legend are of all of them together, and all have one
/// projection and one scale. Title, size, units, classes' rule and tags are those of the first. One
/// map alone is drawn as encode_picture draws it.
///
/// Requires at least one map, all of one study. Throws Error as encode_picture does, and where maps
/// would be too small to be read. Cost: that of a picture of all pixels, and of the vertices of
/// each map. Memory beside the maps: the page, and the shapes of one map.
std::string encode_multiples(std::span<const Picture> maps, PictureFormat format,
                             ImageEncoder encoder, Warnings& warnings);

}  // namespace thiessen
