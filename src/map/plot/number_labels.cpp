#include "map/plot/number_labels.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "map/ink/ink.h"
#include "map/opencv/halo.h"

namespace thiessen {

NumberLabels::NumberLabels(Canvas& canvas, const PixelBox& panel, Typesetter& type, int size)
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
    const std::uint64_t dark = darkness(box);
    if (best && dark >= least_dark) continue;
    best = box;
    least_dark = dark;
  }
  if (!best) return false;
  const int x = panel_.x + best->x;
  const int y = panel_.y + best->y;
  canvas_.blend(x, y, halo(text.ink, rim_), ink::white, 225);
  canvas_.blend(x + rim_, y + rim_, text.ink, colour);
  taken_.occupy(*best);
  return true;
}

std::uint64_t NumberLabels::darkness(const PixelBox& box) {
  std::uint64_t sum = 0;
  const auto& bytes = canvas_.bytes();
  for (int row = 0; row < box.height; ++row) {
    const auto first = 3 * (static_cast<std::size_t>(panel_.y + box.y + row) *
                                static_cast<std::size_t>(canvas_.width()) +
                            static_cast<std::size_t>(panel_.x + box.x));
    for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(box.width); ++i) {
      sum += 255u - bytes[first + i];
    }
  }
  return sum;
}

}  // namespace thiessen
