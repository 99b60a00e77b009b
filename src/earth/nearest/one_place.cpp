#include "earth/nearest/one_place.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <numeric>

#include "earth/nearest/in_space.h"
#include "geometry/hash_mixing.h"

namespace thiessen {
namespace {

/// A cube of space in a grid.
struct Cube {
  std::int64_t x;
  std::int64_t y;
  std::int64_t z;
  friend auto operator<=>(const Cube&, const Cube&) = default;
};

/// A position in a cube, or near enough to it.
struct Entry {
  Cube cube;
  std::uint32_t position;
  friend auto operator<=>(const Entry&, const Entry&) = default;
};

constexpr double coarse_side = 1e-3;  // metres
// No two positions in a cube of this side are farther apart than one_place.
constexpr double fine_side = one_place / 2;
// So many positions in a cube are compared each with each.
constexpr std::size_t few = 16;

/// The cubes next to each other along one axis in which a position is, or from which it is no
/// farther than one_place.
struct Reach {
  std::int64_t first;
  std::int64_t last;
};
Reach reach_of(double at) {
  return {static_cast<std::int64_t>(std::floor((at - one_place) / coarse_side)),
          static_cast<std::int64_t>(std::floor((at + one_place) / coarse_side))};
}

std::uint64_t hash_of(const Cube& cube) {
  const std::uint64_t x = mixed_bits(static_cast<std::uint64_t>(cube.x));
  const std::uint64_t y = mixed_bits(x ^ static_cast<std::uint64_t>(cube.y));
  return mixed_bits(y ^ static_cast<std::uint64_t>(cube.z));
}

/// Numbers of which some come more than once: it may say so of one that does not, of an eighth of
/// them or less.
class Repeated {
 public:
  explicit Repeated(std::size_t count)
      : is_met_(std::bit_ceil(bits_a_number * count + 1), false),
        is_repeated_(is_met_.size(), false) {}

  void add(std::uint64_t number) {
    const std::size_t at = number & (is_met_.size() - 1);
    if (is_met_[at]) is_repeated_[at] = true;
    is_met_[at] = true;
  }
  bool has(std::uint64_t number) const { return is_repeated_[number & (is_met_.size() - 1)]; }

 private:
  static constexpr std::size_t bits_a_number = 8;

  std::vector<bool> is_met_;
  std::vector<bool> is_repeated_;
};

/// Takes out the entries that are alone in their cubes, but for those whose cubes have the hash of
/// another one: an eighth of them or less.
void take_out_lone(std::vector<Entry>& entries) {
  Repeated cubes(entries.size());
  for (const Entry& entry : entries) cubes.add(hash_of(entry.cube));
  std::erase_if(entries, [&](const Entry& e) { return !cubes.has(hash_of(e.cube)); });
}

/// The positions that may be within one_place of another, as longitudes and latitudes tell without
/// a look at space: in cells of 1e-8 degrees no other is in the cells of the rest.
std::vector<std::uint32_t> not_alone(std::span<const Point> positions) {
  constexpr double side = 1e-8;
  // More than one_place, as latitude and as longitude where it is told.
  constexpr double reach = 1e-10;
  constexpr double farthest_north = 80;
  constexpr double farthest_east = 179;
  const auto is_told = [](Point p) {
    return std::abs(p.y) <= farthest_north && std::abs(p.x) <= farthest_east;
  };
  const auto for_each_cell = [](Point p, auto&& visit) {
    const auto cell = [](double at) { return static_cast<std::int64_t>(std::floor(at / side)); };
    for (std::int64_t x = cell(p.x - reach); x <= cell(p.x + reach); ++x) {
      for (std::int64_t y = cell(p.y - reach); y <= cell(p.y + reach); ++y)
        visit(
            mixed_bits(mixed_bits(static_cast<std::uint64_t>(x)) ^ static_cast<std::uint64_t>(y)));
    }
  };
  Repeated cells(positions.size());
  for (const Point p : positions) for_each_cell(p, [&](std::uint64_t cell) { cells.add(cell); });
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    bool may_be = !is_told(positions[i]);
    if (!may_be)
      for_each_cell(positions[i], [&](std::uint64_t cell) { may_be = may_be || cells.has(cell); });
    if (may_be) found.push_back(i);
  }
  return found;
}

Cube fine_cube(Direction p) {
  const auto number = [](double at) {
    return static_cast<std::int64_t>(std::floor(at / fine_side));
  };
  return {number(p.x), number(p.y), number(p.z)};
}

/// Joins positions to places.
class Joining {
 public:
  explicit Joining(std::span<const Point> positions)
      : positions_(positions), some_(not_alone(positions)), parent_(positions.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    in_space_.resize(positions.size());
    for (const std::uint32_t i : some_) in_space_[i] = in_space(positions[i], Metric::geodesic);
  }

  std::vector<std::uint32_t> result() && {
    const std::vector<Entry> entries = coarse_entries();
    for_each_cube(entries, [this](std::span<const Entry> cube) { join_within(cube); });
    std::vector<std::uint32_t> least(parent_.size());
    std::iota(least.begin(), least.end(), 0u);
    for (std::uint32_t i = 0; i < parent_.size(); ++i) {
      std::uint32_t& of_place = least[root(i)];
      if (positions_[i] < positions_[of_place] ||
          (positions_[i] == positions_[of_place] && i < of_place))
        of_place = i;
    }
    std::vector<std::uint32_t> joined(parent_.size());
    for (std::uint32_t i = 0; i < parent_.size(); ++i) joined[i] = least[root(i)];
    return joined;
  }

 private:
  // Positions within one_place of each other have at least one coarse cube in common. Cubes that
  // hold one position are left out, which spares sorting where all are apart.
  std::vector<Entry> coarse_entries() const {
    std::vector<Entry> entries;
    entries.reserve(some_.size());
    for (const std::uint32_t i : some_) {
      const Reach x = reach_of(in_space_[i].x);
      const Reach y = reach_of(in_space_[i].y);
      const Reach z = reach_of(in_space_[i].z);
      for (std::int64_t a = x.first; a <= x.last; ++a) {
        for (std::int64_t b = y.first; b <= y.last; ++b) {
          for (std::int64_t c = z.first; c <= z.last; ++c) entries.push_back({{a, b, c}, i});
        }
      }
    }
    take_out_lone(entries);
    std::sort(entries.begin(), entries.end());
    return entries;
  }

  template <typename Visit>
  static void for_each_cube(std::span<const Entry> entries, const Visit& visit) {
    for (std::size_t first = 0; first < entries.size();) {
      std::size_t end = first + 1;
      while (end < entries.size() && entries[end].cube == entries[first].cube) ++end;
      visit(entries.subspan(first, end - first));
      first = end;
    }
  }

  void join_within(std::span<const Entry> coarse) {
    if (coarse.size() < 2) return;
    if (coarse.size() <= few) {
      for (std::size_t i = 1; i < coarse.size(); ++i)
        join_if_near(coarse.subspan(i, 1), coarse.first(i), false);
      return;
    }
    std::vector<Entry> fine;
    fine.reserve(coarse.size());
    for (const Entry& entry : coarse)
      fine.push_back({fine_cube(in_space_[entry.position]), entry.position});
    std::sort(fine.begin(), fine.end());
    for_each_cube(fine, [&](std::span<const Entry> cube) {
      for (const Entry& entry : cube) join(cube.front().position, entry.position);
    });
    for_each_cube(fine, [&](std::span<const Entry> cube) { join_with_later(cube, fine); });
  }

  // Joins a fine cube with those after it that are near: two cubes away at most.
  void join_with_later(std::span<const Entry> cube, std::span<const Entry> fine) {
    const Cube at = cube.front().cube;
    constexpr std::int64_t far = 2;
    for (std::int64_t x = 0; x <= far; ++x) {
      for (std::int64_t y = -far; y <= far; ++y) {
        const Cube from{at.x + x, at.y + y, at.z - far};
        auto entry = std::lower_bound(fine.begin(), fine.end(), std::max(from, at),
                                      [](const Entry& e, const Cube& c) { return e.cube < c; });
        while (entry != fine.end() && entry->cube <= Cube{from.x, from.y, at.z + far}) {
          auto end = entry;
          while (end != fine.end() && end->cube == entry->cube) ++end;
          if (entry->cube != at) join_if_near(cube, {entry, end}, true);
          entry = end;
        }
      }
    }
  }

  // Joins positions of two groups that are near. Where each group is one place already, the first
  // such pair is enough.
  void join_if_near(std::span<const Entry> some, std::span<const Entry> others, bool are_places) {
    if (are_places && root(some.front().position) == root(others.front().position)) return;
    for (const Entry& a : some) {
      for (const Entry& b : others) {
        if (length(in_space_[a.position] - in_space_[b.position]) > one_place) continue;
        join(a.position, b.position);
        if (are_places) return;
      }
    }
  }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

  std::span<const Point> positions_;
  std::vector<std::uint32_t> some_;    // those that may have others at their places
  std::vector<Direction> in_space_;    // of these
  std::vector<std::uint32_t> parent_;  // towards the position that stands for the place
};

}  // namespace

std::vector<std::uint32_t> joined_positions(std::span<const Point> positions) {
  return Joining(positions).result();
}

}  // namespace thiessen
