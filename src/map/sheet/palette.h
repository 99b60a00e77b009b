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

/// Colours `count` items by numbers below `colours` so that neighbours differ. They always do where
/// the neighbourhoods are those of a map in the plane and `colours` is 6 or more (smallest-last
/// order, Matula and Beck 1983), else as far as greedy choice goes. Of the colours free at an item
/// the least used so far is taken. Pairs may repeat and come in any order, without changing the
/// result. Cost: the pairs and items, and sorting the pairs.
std::vector<std::uint8_t> colour_neighbours(
    std::size_t count, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs,
    std::size_t colours);

}  // namespace thiessen
