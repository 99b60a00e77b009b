#include "map/ink/scanline.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/interrupt.h"

namespace thiessen {
namespace {

constexpr std::size_t word_bits = 64;

/// The first pixel, along an axis of `size` pixels, whose centre lies at or beyond `position`.
int first_centre(double position, int size) {
  return static_cast<int>(std::clamp(std::ceil(position - 0.5), 0.0, static_cast<double>(size)));
}

/// Sets each bit of the result where `word` has an odd number of bits set up to that bit, itself
/// included.
std::uint64_t prefix_parity(std::uint64_t word) {
  for (std::size_t shift = 1; shift < word_bits; shift *= 2) word ^= word << shift;
  return word;
}

}  // namespace

OwnerRaster::OwnerRaster(int width, int height, std::int32_t before)
    : width_(width),
      height_(height),
      words_((static_cast<std::size_t>(width) + word_bits - 1) / word_bits),
      top_(height),
      owners_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), before),
      odd_(words_ * static_cast<std::size_t>(height)),
      touched_(static_cast<std::size_t>(height), Touched{words_, 0}) {}

void OwnerRaster::fill(std::span<const Ring> rings, std::int32_t owner) {
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      cross(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    }
  }
  for (int row = top_; row <= bottom_; ++row) {
    throw_if_interrupted();
    fill_row(row, owner);
  }
  top_ = height_;
  bottom_ = -1;
}

void OwnerRaster::cross(Point a, Point b) {
  if (b.y < a.y || (b.y == a.y && b.x < a.x)) std::swap(a, b);
  const int first = first_centre(a.y, height_);
  const int end = first_centre(b.y, height_);
  if (first >= end) return;
  const double slope = (b.x - a.x) / (b.y - a.y);
  for (int row = first; row < end; ++row) {
    const double x = a.x + (row + 0.5 - a.y) * slope;
    toggle(first_centre(x, width_), row);
  }
  top_ = std::min(top_, first);
  bottom_ = std::max(bottom_, end - 1);
}

void OwnerRaster::toggle(int column, int row) {
  if (column >= width_) return;
  const auto line = static_cast<std::size_t>(row);
  const std::size_t word = static_cast<std::size_t>(column) / word_bits;
  odd_[line * words_ + word] ^= std::uint64_t{1} << (static_cast<std::size_t>(column) % word_bits);
  touched_[line].first = std::min(touched_[line].first, word);
  touched_[line].last = std::max(touched_[line].last, word);
}

void OwnerRaster::fill_row(int row, std::int32_t owner) {
  const auto line = static_cast<std::size_t>(row);
  bool inside = false;
  for (std::size_t word = touched_[line].first; word < words_; ++word) {
    if (word > touched_[line].last && !inside) break;
    std::uint64_t& crossings = odd_[line * words_ + word];
    std::uint64_t filled = prefix_parity(crossings);
    if (inside) filled = ~filled;
    inside = (filled >> (word_bits - 1)) != 0;
    crossings = 0;
    while (filled != 0) {
      const std::size_t bit = static_cast<std::size_t>(std::countr_zero(filled));
      const std::size_t column = word * word_bits + bit;
      if (column >= static_cast<std::size_t>(width_)) break;
      owners_[line * static_cast<std::size_t>(width_) + column] = owner;
      filled &= filled - 1;
    }
  }
  touched_[line] = {words_, 0};
}

}  // namespace thiessen
