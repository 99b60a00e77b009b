#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "map/ink/canvas.h"

namespace thiessen {

/// The colours of rainfall's classes. In each the lightness rises or falls evenly, so that the
/// order is plain in grey and to colour-blind readers too.
enum class Palette {
  viridis,  ///< from dark purple through teal to yellow, after matplotlib's
  blues,    ///< from pale to dark, as the two below
  browns,
  greys,
};

/// The colour of class `index` of `count` classes.
Colour sequential_colour(Palette palette, std::size_t index, std::size_t count);

/// Soft colours that can be told apart side by side.
std::span<const Colour> categorical_colours();

/// Gathers the pairs of items that touch in a raster. A pair is kept once, or a few times where it
/// comes again after others; memory grows with the pairs that differ, and not with the pixels.
class TouchingPairs {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  /// Takes note that two pixels of these items, which may be one, lie beside each other.
  void add(std::uint32_t a, std::uint32_t b);
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  std::vector<Pair> pairs_;
  std::size_t most_ = 1'000'000;  ///< that are kept before repeated ones are taken out
};

/// Colours `count` items by numbers below `colours` so that neighbours differ. They always do where
/// the neighbourhoods are those of a map in the plane and `colours` is 6 or more (smallest-last
/// order, Matula and Beck 1983), else as far as greedy choice goes. Of the colours free at an item
/// the least used so far is taken. Pairs may repeat and come in any order, without changing the
/// result. Cost: the pairs and items, and sorting the pairs.
std::vector<std::uint8_t> colour_neighbours(
    std::size_t count, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs,
    std::size_t colours);

}  // namespace thiessen
