#include "geometry/insertion_order.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <span>
#include <utility>

#include "base/interrupt.h"
#include "geometry/hilbert.h"
#include "geometry/rank_order.h"

namespace thiessen {

InsertionRounds::InsertionRounds(std::size_t points) {
  for (std::size_t left = points / ratio; left >= smallest; left /= ratio) ++last_;
}

std::uint32_t InsertionRounds::of(std::size_t i) const {
  constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio
  std::uint64_t mixed = (i + 1) * golden;
  mixed ^= mixed >> 32;
  mixed *= golden;
  mixed ^= mixed >> 29;
  mixed *= golden;
  // Each point belongs to the round before with a chance of 1 in `ratio`, so leading zeros of a
  // random number choose its round.
  constexpr int bits = std::countr_zero(ratio);
  const auto back = static_cast<std::uint32_t>(std::countl_zero(mixed | 1) / bits);
  return last_ - std::min(back, last_);
}

namespace {

using Entry = RankedIndex;
constexpr int index_bits = ranked_index_bits;

bool same_rank(Entry a, Entry b) {
  return (a ^ b) >> index_bits == 0;
}

template <int Dimension>
class CurveOrder {
 public:
  using Position = PositionIn<Dimension>;
  using Grid = HilbertGrid<Dimension>;

  explicit CurveOrder(std::span<const Position> points)
      : points_(points),
        order_(points.size()),
        entries_(std::make_unique_for_overwrite<Entry[]>(points.size())),
        spare_(std::make_unique_for_overwrite<Entry[]>(points.size())) {}

  std::vector<std::uint32_t> result() && {
    sort_in_rounds();
    while (!crowded_.empty()) {
      throw_if_interrupted();
      const Stretch cell = crowded_.back();
      crowded_.pop_back();
      sort_cell(cell);
    }
    return std::move(order_);
  }

 private:
  /// A stretch of the order, from `begin` up to before `end`.
  struct Stretch {
    std::uint32_t begin;
    std::uint32_t end;
  };

  /// At most this many points of one cell stay in the order in which they come, because the order
  /// among so few hardly matters.
  static constexpr std::size_t crowd = 8;

  void sort_in_rounds() {
    const InsertionRounds rounds(points_.size());
    const int round_bits = static_cast<int>(std::bit_width(rounds.count() - 1));
    const auto point = [&](std::size_t i) -> const Position& { return points_[i]; };
    const CellCurve curve(points_.size(), point, round_bits);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Entry rank = Entry{rounds.of(i)} << curve.bits | curve.rank(points_[i]);
      entries_[i] = rank << index_bits | i;
    }
    take_sorted({0, static_cast<std::uint32_t>(points_.size())}, round_bits + curve.bits);
  }

  void sort_cell(Stretch cell) {
    const std::uint32_t* members = order_.data() + cell.begin;
    const std::size_t count = cell.end - cell.begin;
    const auto point = [&](std::size_t i) -> const Position& { return points_[members[i]]; };
    const CellCurve curve(count, point, 0);
    if (!curve.grid.divides()) return;
    for (std::size_t i = 0; i < count; ++i) {
      entries_[i] = Entry{curve.rank(point(i))} << index_bits | members[i];
    }
    take_sorted(cell, curve.bits);
  }

  /// The curve through the box of some points. It uses as many bits of the distance as tell most of
  /// the points apart.
  struct CellCurve {
    Grid grid;
    int bits;

    template <typename At>
    CellCurve(std::size_t count, const At& at, int other_bits)
        : grid(grid_of(count, at)),
          bits(std::min({static_cast<int>(std::bit_width(count)) + 4, index_bits - other_bits,
                         Grid::distance_bits})) {}

    std::uint32_t rank(const Position& p) const {
      return grid.distance(p) >> (Grid::distance_bits - bits);
    }
  };

  template <typename At>
  static Grid grid_of(std::size_t count, const At& at) {
    if (count == 0) return Grid({}, {});
    auto low = coordinates(at(0));
    auto high = low;
    for (std::size_t i = 1; i < count; ++i) {
      const auto c = coordinates(at(i));
      for (std::size_t axis = 0; axis < c.size(); ++axis) {
        low[axis] = std::min(low[axis], c[axis]);
        high[axis] = std::max(high[axis], c[axis]);
      }
    }
    return Grid(low, high);
  }

  void take_sorted(Stretch stretch, int rank_bits) {
    const std::size_t count = stretch.end - stretch.begin;
    const std::span<const Entry> entries =
        sorted_by_rank({entries_.get(), count}, {spare_.get(), count}, rank_bits);
    for (std::size_t i = 0; i < count; ++i) order_[stretch.begin + i] = index_of(entries[i]);
    for (std::size_t i = 0; i + crowd < count; ++i) {
      if (!same_rank(entries[i], entries[i + crowd])) continue;
      std::size_t end = i + crowd + 1;
      while (end < count && same_rank(entries[i], entries[end])) ++end;
      crowded_.push_back({stretch.begin + static_cast<std::uint32_t>(i),
                          stretch.begin + static_cast<std::uint32_t>(end)});
      i = end - 1;
    }
  }

  std::span<const Position> points_;
  std::vector<std::uint32_t> order_;
  std::unique_ptr<Entry[]> entries_;
  std::unique_ptr<Entry[]> spare_;
  std::vector<Stretch> crowded_;
};

}  // namespace

template <int Dimension>
std::vector<std::uint32_t> insertion_order(std::span<const PositionIn<Dimension>> points) {
  return CurveOrder<Dimension>(points).result();
}

template std::vector<std::uint32_t> insertion_order<2>(std::span<const Point>);
template std::vector<std::uint32_t> insertion_order<3>(std::span<const SpacePoint>);

}  // namespace thiessen
