#pragma once

#include <string>
#include <utility>
#include <vector>

namespace thiessen {

/// Names and values that a picture's file says of itself.
using PictureTags = std::vector<std::pair<std::string, std::string>>;

/// Puts texts into the bytes of a PNG, behind its header: a chunk tEXt for each, or iTXt where it
/// is not ASCII. The name `software` becomes PNG's own keyword Software. Requires names of 1 to 79
/// letters.
void tag_png(std::vector<unsigned char>& bytes, const PictureTags& tags);

/// Puts the texts into the bytes of a JPEG as one comment, `name: value` parted by semicolons.
void tag_jpeg(std::vector<unsigned char>& bytes, const PictureTags& tags);

/// Says the density in the bytes of a PNG, behind its header: a chunk pHYs, in whole pixels to the
/// metre. Requires a density from 1 to 65,535.
void say_png_density(std::vector<unsigned char>& bytes, int dots_to_the_inch);

/// Says the density in the header of a JPEG file that begins as JFIF does; any other is left as it
/// is. Requires a density from 1 to 65,535.
void say_jpeg_density(std::vector<unsigned char>& bytes, int dots_to_the_inch);

}  // namespace thiessen
