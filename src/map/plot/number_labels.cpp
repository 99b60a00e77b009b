#include "map/plot/number_labels.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "map/ink/ink.h"

namespace thiessen {

NumberLabels::NumberLabels(PixelCanvas& canvas, const PixelBox& panel, Typesetter& type, int size)
    : canvas_(canvas),
      panel_(panel),
      type_(type),
      size_(size),
      rim_(std::max(1, size / 9)),
      taken_(panel.width, panel.height) {}

void NumberLabels::keep_clear(Point dot, double radius) {
  const int x = static_cast<int>(std::floor(dot.x - radius)) - panel_.x;
  const int y = static_cast<int>(std::floor(dot.y - radius)) - panel_.y;
  const int side = static_cast<int>(std::ceil(2 * radius)) + 1;
  taken_.occupy({x, y, side, side});
}

bool NumberLabels::write(std::uint64_t number, Point dot, double radius, Colour colour) {
  const std::string digits = std::to_string(number);
  const int least =
      size_ * static_cast<int>(digits.size()) / 2;  // a lower bound: numerals are wider than that
  const Point in_panel{dot.x - panel_.x, dot.y - panel_.y};
  if (!place_beside(taken_, in_panel, radius, 1, least, size_ / 2)) return false;
  const SetText text = type_.set(digits, size_);
  std::optional<PixelBox> best;
  std::uint64_t least_dark = 0;
  for (const PixelBox& box :
       boxes_beside(in_panel, radius, 1, text.width() + 2 * rim_, text.height() + 2 * rim_)) {
    if (!taken_.is_free(box)) continue;
    const std::uint64_t dark =
        canvas_.darkness({panel_.x + box.x, panel_.y + box.y, box.width, box.height});
    if (best && dark >= least_dark) continue;
    best = box;
    least_dark = dark;
  }
  if (!best) return false;
  canvas_.text(text, panel_.x + best->x + rim_, panel_.y + best->y + rim_, {colour, rim_, {}});
  taken_.occupy(*best);
  return true;
}

}  // namespace thiessen
