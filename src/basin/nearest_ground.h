#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "basin/basin.h"
#include "diagram/nearness.h"
#include "earth/sphere/gnomonic_chart.h"

namespace thiessen {

/// Divides a piece of ground by which places are nearest to its points, for few places, all of
/// which are looked at: half plane by half plane, without a tessellation. In a chart an edge
/// between two places is a chord that ends where the places are equally near, and the area between
/// it and the true edge is told by how far that lies off in the middle.
///
/// A ring is cut as a closed line (I. E. Sutherland and G. W. Hodgman, Reentrant polygon clipping,
/// 1974), so what is left of it may run along a cut back and forth; areas are right all the same,
/// of holes and of rings that bend in as well.
class NearestGround {
 public:
  /// In a plane whose square unit has this area, until it is given a chart.
  explicit NearestGround(double unit_area = 1) : unit_area_(unit_area) {}

  /// Measures in a chart from now on, which must outlive what is done there.
  void take_chart(const GnomonicChart& chart) { chart_ = &chart; }
  /// Takes the places by how near they are: all calls below number them in this order. The list
  /// must outlive these calls.
  void take_places(std::span<const Nearness> places) { places_ = places; }
  /// Takes the ground, in coordinates from an origin, which is 0 in a chart.
  void take_ground(const Basin& ground, Point origin = {});
  double area() const { return area_of(ground_); }

  /// The areas of the ground to whose points the first `members` places are nearer than all others
  /// and one of these is the next: by place from `members` on. `own`, one of the members, is known
  /// to be nearer than the others everywhere. Cost: the corners, times the places, times the
  /// members or the places that are next somewhere.
  std::span<const double> areas_by_next(std::size_t members, std::size_t own);

 private:
  static constexpr std::uint32_t of_ground = 0xFFFFFFFFu;
  /// A corner, and the edge to the one after it.
  struct Corner {
    Point at;
    double bulge;  ///< of the whole edge of the ground that this is of: see Basin::bulges
    double begin;  ///< the share of that edge which lies before this one, and up to its end
    double end;
    /// The places that the edge is between; `of_ground` for one of the ground's own.
    std::uint32_t nearer;
    std::uint32_t farther;
  };
  using Line = std::vector<Corner>;
  /// Rings one after the other; lists that are empty are not freed.
  struct Lines {
    std::vector<Line> lines;
    std::size_t count = 0;

    std::span<const Line> all() const { return std::span(lines).first(count); }
    Line& add();
  };
  /// The sides on which the corners of lines lie.
  enum class Side { nearer, farther, both };

  void add_ring(const Ring& ring, const std::vector<double>* bulges, Point origin);
  Side side_of(const Lines& lines, std::size_t a, std::size_t b) const;
  bool cut(Lines& lines, std::uint32_t nearer, std::uint32_t farther);
  void cut(const Line& line, const Nearness& border, const Corner& along, Line& left);
  void add_crossing(const Corner& from, Point to, const Nearness& border,
                    std::pair<double, double> values, const Corner& along, Line& left) const;
  Point moved_onto_both(Point near, const Nearness& one, const Nearness& other) const;
  void find_next(std::size_t members);
  double area_of(const Lines& lines) const;
  double bulge_of(const Corner& from, Point to) const;

  const GnomonicChart* chart_ = nullptr;
  double unit_area_ = 1;
  std::span<const Nearness> places_;
  Lines ground_;
  Lines left_;  // of the ground, for the members
  Lines part_;  // of that, for one that is next
  Line spare_;
  std::vector<double> values_;       // by corner
  std::vector<std::uint32_t> next_;  // the places that are next somewhere
  std::vector<double> areas_;
};

}  // namespace thiessen
