#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "earth/sphere/sphere_tessellation.h"

namespace thiessen {

/// A side of one of the mesh's triangles: the one across from the corner of the same number.
enum class SideIndex : std::uint32_t {};
constexpr std::size_t index(SideIndex i) {
  return static_cast<std::size_t>(i);
}

/// The triangles of a sphere's tessellation, as a closed mesh whose sides can be flipped to turn it
/// into the tessellation of the ellipsoid. Three or more places on one circle have a fan of
/// triangles on either side of it. Two triangles may share two sides, and two places may be joined
/// by two sides, so a side is known by its number only.
class CellMesh {
 public:
  /// Requires at least three places with cells of their own.
  explicit CellMesh(const SphereTessellation& sphere);

  std::uint32_t triangles() const { return static_cast<std::uint32_t>(corners_.size() / 3); }
  std::uint32_t sides() const { return static_cast<std::uint32_t>(corners_.size()); }
  static std::uint32_t triangle_of(SideIndex s) { return static_cast<std::uint32_t>(s) / 3; }
  static SideIndex side(std::uint32_t triangle, std::uint32_t corner) {
    return SideIndex{3 * triangle + corner};
  }
  /// A side as the triangle beyond it has it.
  SideIndex twin(SideIndex s) const { return twin_[index(s)]; }
  /// The side that follows s counter-clockwise round its triangle.
  static SideIndex next(SideIndex s) { return turned(s, 1); }
  /// The side before s, counter-clockwise round its triangle.
  static SideIndex previous(SideIndex s) { return turned(s, 2); }
  /// The corner across from the side.
  PlaceIndex apex(SideIndex s) const { return corners_[index(s)]; }
  /// The place at which the side begins, counter-clockwise round its triangle.
  PlaceIndex from(SideIndex s) const { return corners_[index(next(s))]; }
  /// The place at which the side ends, counter-clockwise round its triangle.
  PlaceIndex to(SideIndex s) const { return corners_[index(previous(s))]; }
  std::array<PlaceIndex, 3> corners(std::uint32_t triangle) const {
    const std::size_t first = index(side(triangle, 0));
    return {corners_[first], corners_[first + 1], corners_[first + 2]};
  }

  /// Calls visit(s) for each edge once: for the one of its two sides that has the lower number,
  /// where that lies from `first` up to, and without, `end`.
  template <typename Visit>
  void for_each_edge(std::uint32_t first, std::uint32_t end, Visit&& visit) const {
    for (std::uint32_t i = first; i < end; ++i) {
      if (SideIndex{i} < twin(SideIndex{i})) visit(SideIndex{i});
    }
  }

  /// Puts the other diagonal into the quadrilateral of the side's two triangles. Requires that
  /// their apexes are different places.
  void flip(SideIndex s);
  /// Replaces the corners of a triangle. This is for code that lays triangles anew: in the end
  /// every side must be joined to another by join.
  void set_corners(std::uint32_t triangle, const std::array<PlaceIndex, 3>& corners);
  /// Makes two sides each other's twins.
  void join(SideIndex a, SideIndex b);

 private:
  static SideIndex turned(SideIndex s, std::uint32_t by) {
    const auto i = static_cast<std::uint32_t>(s);
    return SideIndex{i - i % 3 + (i % 3 + by) % 3};
  }
  void take_over(const SphereTessellation& sphere);
  void add_fans(const SphereTessellation& sphere);

  std::vector<PlaceIndex> corners_;
  std::vector<SideIndex> twin_;
};

}  // namespace thiessen
