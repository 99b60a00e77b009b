#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "geometry/coordinates.h"

/// Hilbert's curve as a state machine: it reads the coordinates of a cell from the leading bits on,
/// and writes the distance along the curve. This works because the curve in each half of a cube is
/// the same curve again, turned; the turn is the state.
namespace thiessen::hilbert {

/// How the curve lies in a cube: the corner in which it starts (one bit for each axis), and the
/// axis along which its end lies from there (C. H. Hamilton, Compact Hilbert indices, 2006,
/// sections 2.1 and 2.2).
template <int Dimension>
struct Turn {
  static constexpr std::uint32_t corners = 1u << Dimension;
  static constexpr std::uint32_t count = corners * Dimension;

  std::uint32_t start = 0;
  std::uint32_t axis = 0;

  static constexpr Turn numbered(std::uint32_t number) {
    return {number / Dimension, number % Dimension};
  }
  constexpr std::uint32_t number() const { return start * Dimension + axis; }

  /// The rank along the curve of the part of the cube (quarter or eighth) that is in this corner.
  constexpr std::uint32_t rank(std::uint32_t corner) const {
    std::uint32_t gray = rotated(corner ^ start, Dimension - 1 - axis);
    for (std::uint32_t shift = 1; shift < Dimension; shift *= 2) gray ^= gray >> shift;
    return gray;
  }

  /// How the curve lies in the part of this rank.
  constexpr Turn within(std::uint32_t rank) const {
    if (rank == 0) return {start, (axis + 1) % Dimension};
    const std::uint32_t even = (rank - 1) / 2 * 2;
    const int ones = std::countr_one(rank % 2 == 1 ? rank : rank - 1);
    return {start ^ rotated(even ^ even / 2, axis + 1),
            (axis + static_cast<std::uint32_t>(ones) + 1) % Dimension};
  }

 private:
  /// Rotates the bits, one for each axis, upward by so many places.
  static constexpr std::uint32_t rotated(std::uint32_t bits, std::uint32_t places) {
    places %= Dimension;
    return (bits << places | bits >> (Dimension - places)) & (corners - 1);
  }
};

/// A table that takes several levels of the curve in one look-up: 4 in the plane, 2 in space.
template <int Dimension>
class Steps {
 public:
  static constexpr int levels = Dimension == 2 ? 4 : 2;
  static constexpr int bits = Dimension * levels;

  constexpr Steps() {
    for (std::uint32_t turn = 0; turn < Turn<Dimension>::count; ++turn) {
      for (std::uint32_t cell = 0; cell < 1u << bits; ++cell) {
        steps_[turn << bits | cell] = step(Turn<Dimension>::numbered(turn), cell);
      }
    }
  }

  /// Takes one step. `before` is the answer of the step before, or 0 at the start; `cell` holds the
  /// next bits of the coordinates, x above y above z. Returns the next `bits` bits of the distance,
  /// and above them the new turn.
  constexpr std::uint32_t next(std::uint32_t before, std::uint32_t cell) const {
    return steps_[(before >> bits << bits) | cell];
  }

 private:
  static constexpr std::uint16_t step(Turn<Dimension> turn, std::uint32_t cell) {
    std::uint32_t distance = 0;
    for (int level = levels - 1; level >= 0; --level) {
      std::uint32_t corner = 0;
      for (int axis = 0; axis < Dimension; ++axis) {
        const int place = (Dimension - 1 - axis) * levels + level;
        corner |= (cell >> place & 1u) << axis;
      }
      const std::uint32_t rank = turn.rank(corner);
      distance = distance << Dimension | rank;
      turn = turn.within(rank);
    }
    return static_cast<std::uint16_t>(turn.number() << bits | distance);
  }

  std::array<std::uint16_t, std::size_t{Turn<Dimension>::count} << bits> steps_{};
};

template <int Dimension>
inline constexpr Steps<Dimension> steps;

/// How far along the curve the cell lies in a grid of 2^levels cells a side. Requires a cell of the
/// grid, and that `levels` is a multiple of Steps::levels.
template <int Dimension, int levels>
std::uint32_t along_curve(const CoordinatesIn<Dimension, std::uint32_t>& cell) {
  using Step = Steps<Dimension>;
  static_assert(levels % Step::levels == 0 && levels * Dimension <= 32);
  std::uint32_t distance = 0;
  std::uint32_t last = 0;
  for (int level = levels - Step::levels; level >= 0; level -= Step::levels) {
    std::uint32_t next = 0;
    for (const std::uint32_t coordinate : cell) {
      next = next << Step::levels | (coordinate >> level & ((1u << Step::levels) - 1));
    }
    last = steps<Dimension>.next(last, next);
    distance = distance << Step::bits | (last & ((1u << Step::bits) - 1));
  }
  return distance;
}

}  // namespace thiessen::hilbert
