#pragma once

#include <cstdint>
#include <vector>

#include "geometry/direction.h"
#include "tessellation/place.h"

namespace thiessen {

/// The points of space within `radius` of the centre.
struct Ball {
  Direction centre;
  double radius = 0;
};

/// A tree of places in space, halved again and again across their longest side until few are left
/// (a k-d tree, J. L. Bentley, 1975); each part lies within a ball. Cost: n log n to build. Memory:
/// 60 bytes a place.
class PlaceTree {
 public:
  /// Requires at least one place.
  explicit PlaceTree(std::vector<Direction> places);

  Direction operator[](PlaceIndex p) const { return places_[index(p)]; }
  /// The place nearest to a point of space. Cost: log n where places lie scattered; at worst n.
  PlaceIndex nearest(Direction to) const { return nearest(to, order_.front()); }
  /// The same, which takes less the nearer `guess` is. Where several are equally near, and not at
  /// the point itself, it is the same one for every guess.
  PlaceIndex nearest(Direction to, PlaceIndex guess) const;
  /// Calls `found(place)` for every place except those of parts whose ball makes `excludes(ball)`
  /// true.
  template <typename Excludes, typename Found>
  void search(Excludes&& excludes, Found&& found) const {
    search_part(0, excludes, found);
  }

 private:
  /// A part of the places. Its first half is the part that follows it in the list; `second` is the
  /// number of its other half, 0 where it is not halved.
  struct Part {
    Ball ball;
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t second;
  };

  struct Entry {
    Direction at;
    PlaceIndex place;
  };

  std::uint32_t add_part(std::vector<Entry>& entries, std::uint32_t begin, std::uint32_t end);
  /// A search for the nearest place: the best so far, and its distance.
  struct Nearest {
    Direction to;
    PlaceIndex best;
    double square;
    double distance;

    /// A place as near as the best may lie on the ball's rim, so rounding is granted to it.
    bool excludes(const Ball& ball) const {
      constexpr double rounding = 1 + 1e-14;
      const Direction way = ball.centre - to;
      const double reach = ball.radius + distance;
      return dot(way, way) > reach * reach * rounding;
    }
  };
  void find_nearest(std::uint32_t part, Nearest& search) const;

  template <typename Excludes, typename Found>
  void search_part(std::uint32_t i, Excludes& excludes, Found& found) const {
    const Part& part = parts_[i];
    if (excludes(part.ball)) return;
    if (part.second != 0) {
      search_part(i + 1, excludes, found);
      search_part(part.second, excludes, found);
      return;
    }
    for (std::uint32_t k = part.begin; k < part.end; ++k) found(order_[k]);
  }

  std::vector<Direction> places_;
  std::vector<PlaceIndex> order_;
  std::vector<Part> parts_;
};

}  // namespace thiessen
