#include "cli/options/picture_size.h"

#include <cmath>
#include <string>

#include "cli/options/usage_error.h"
#include "map/sheet/picture.h"

namespace thiessen::cli {

int PictureSize::dots_to_the_inch() const {
  constexpr int of_print = 300;
  return dpi == 0 && size.millimetres ? of_print : static_cast<int>(dpi);
}

int PictureSize::width() const {
  return pixels(size.width);
}

int PictureSize::height() const {
  return pixels(size.height);
}

int PictureSize::pixels(std::size_t side) const {
  constexpr double millimetres_to_the_inch = 25.4;
  if (!size.millimetres) return static_cast<int>(side);
  return static_cast<int>(
      std::lround(static_cast<double>(side) * dots_to_the_inch() / millimetres_to_the_inch));
}

void PictureSize::check_size() const {
  if (!size.millimetres) return;
  const auto fits = [](int side) { return side >= min_picture_side && side <= max_picture_side; };
  const bool good = fits(width()) && (size.height == 0 || fits(height())) &&
                    static_cast<long long>(width()) * height() <= max_picture_pixels;
  if (good) return;
  throw UsageError{"a picture of this --size in mm is " + std::to_string(width()) +
                       (size.height == 0 ? "" : " x " + std::to_string(height())) + " pixels at " +
                       std::to_string(dots_to_the_inch()) + " dots to the inch; the limits are " +
                       std::to_string(min_picture_side) + " to " +
                       std::to_string(max_picture_side) + " a side and " +
                       std::to_string(max_picture_pixels) + " in all",
                   "choose another --dpi"};
}

}  // namespace thiessen::cli
