#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "geometry/coordinates.h"
#include "tessellation/audit.h"
#include "tessellation/history.h"
#include "tessellation/simplices.h"

namespace thiessen::fuzzers {
namespace {

constexpr std::size_t longest_run = 150;

/// A few coordinates, so that points are equal, on a line, on a circle or nearly so.
enum class Grid : std::uint8_t { whole, small, tenths, ulps, scales };
constexpr std::size_t grids = 5;

double coordinate(Grid grid, std::uint8_t byte) {
  const auto value = static_cast<double>(byte % 16) - 7;
  switch (grid) {
    case Grid::whole:
      return value;
    case Grid::small:
      return static_cast<double>(byte % 3);
    case Grid::tenths:
      return 500000 + 0.1 * value;
    case Grid::ulps: {
      constexpr std::array<double, 4> near = {0.1, 0.5, 1, 4e6};
      double c = near[byte / 4 % 4];
      for (int i = 0; i < byte % 4; ++i) c = std::nextafter(c, 8e6);
      return c;
    }
    case Grid::scales: {
      constexpr std::array<double, 8> scales = {1, 1e-40, 1e-20, 1e-8, 1e8, 1e16, 1e30, 1e59};
      return value * scales[byte / 16 % 8];
    }
  }
  return 0;
}

template <int Dimension>
class Operations {
 public:
  using Position = PositionIn<Dimension>;
  using Points = std::set<Position>;

  explicit Operations(Bytes& bytes)
      : bytes_(bytes), grid_(Grid{static_cast<std::uint8_t>(bytes.below(grids))}) {}

 protected:
  Position any_position() {
    CoordinatesIn<Dimension> c;
    for (double& x : c) x = coordinate(grid_, bytes_.next());
    return position_of<Dimension>(c);
  }
  std::vector<Position> some_positions() {
    std::vector<Position> positions(bytes_.below(12));
    for (Position& p : positions) p = any_position();
    return positions;
  }
  std::optional<PointId> any_hint() {
    const std::uint8_t byte = bytes_.next();
    if (byte >= 128) return std::nullopt;
    return byte == 127 ? no_point : PointId{byte};
  }
  /// Requires that there is one.
  PointId any_there(const Tessellation<Dimension>& tessellation) {
    std::size_t k = bytes_.below(tessellation.count());
    PointId found = no_point;
    tessellation.for_each_point([&](PointId p) {
      if (k-- == 0) found = p;
    });
    return found;
  }

  static void require_sound(const Tessellation<Dimension>& tessellation, const Points& points) {
    const auto findings = audit(tessellation);
    require(findings.empty(), findings.empty() ? "" : std::string(name_of(findings.front().fault)));
    require(positions_of(tessellation) == std::vector<Position>(points.begin(), points.end()),
            "other points than were added");
  }
  /// The same as one built from scratch, backward.
  static void require_rebuilt(const Tessellation<Dimension>& tessellation, const Points& points) {
    const std::vector<Position> backward(points.rbegin(), points.rend());
    const Tessellation<Dimension> rebuilt = tessellation_of(backward);
    require(tessellation.span() == rebuilt.span(), "another span than from scratch");
    require(plain_simplices(tessellation) == plain_simplices(rebuilt),
            "other simplices than from scratch");
  }
  void query(const Tessellation<Dimension>& tessellation, const Points& points) {
    const Position p = any_position();
    const auto found = tessellation.find(p, any_hint());
    require(found.has_value() == points.contains(p), "found what is not there, or not what is");
    require(!found || tessellation.position(*found) == p, "found another point");
    const auto nearest = tessellation.nearest(p, any_hint());
    const auto expected =
        nearest_one_by_one(std::vector<Position>(points.begin(), points.end()), p);
    require(nearest.has_value() == expected.has_value(), "nearest of none, or none of some");
    require(!nearest || tessellation.position(*nearest) == *expected, "not the nearest");
  }

  Bytes& bytes_;

 private:
  Grid grid_;
};

/// Insertions and deletions, undone and redone.
template <int Dimension>
class Undoing : public Operations<Dimension> {
 public:
  using Base = Operations<Dimension>;
  using Base::Base;
  using typename Base::Points;
  using typename Base::Position;

  void run() {
    for (std::size_t step = 0; step < longest_run && !bytes_.empty(); ++step) {
      operate();
      Base::require_sound(history_.tessellation(), points());
      require(history_.undoable() == at_ && history_.redoable() == states_.size() - 1 - at_,
              "other operations than were made");
    }
    Base::require_rebuilt(history_.tessellation(), points());
    while (history_.undo()) --at_;
    require(at_ == 0, "not all is undone");
    Base::require_sound(history_.tessellation(), {});
    while (history_.redo()) ++at_;
    require(at_ + 1 == states_.size(), "not all is redone");
    Base::require_sound(history_.tessellation(), points());
    Base::require_rebuilt(history_.tessellation(), points());
  }

 private:
  using Base::bytes_;

  const Points& points() const { return states_[at_]; }
  Points& begin() {
    states_.resize(at_ + 1);
    states_.push_back(states_.back());
    return states_[++at_];
  }

  void operate() {
    switch (bytes_.below(8)) {
      case 0:
        require(history_.undo() == (at_ > 0), "undo before the beginning");
        if (at_ > 0) --at_;
        return;
      case 1:
        require(history_.redo() == (at_ + 1 < states_.size()), "redo beyond the end");
        if (at_ + 1 < states_.size()) ++at_;
        return;
      case 2:
      case 3:
        return remove();
      case 4:
        return add_many();
      case 5:
        return Base::query(history_.tessellation(), points());
      default:
        return add();
    }
  }
  void remove() {
    if (points().empty()) return;
    const PointId p = Base::any_there(history_.tessellation());
    begin().erase(history_.tessellation().position(p));
    history_.remove(p);
  }
  void add() {
    const Position p = Base::any_position();
    const PointId number = history_.add(p, Base::any_hint());
    require(history_.tessellation().position(number) == p, "the number of another point");
    begin().insert(p);
  }
  void add_many() {
    const std::vector<Position> positions = Base::some_positions();
    const std::vector<PointId> numbers = history_.add_all(positions);
    require(numbers.size() == positions.size(), "not a number a point");
    for (std::size_t i = 0; i < numbers.size(); ++i)
      require(history_.tessellation().position(numbers[i]) == positions[i],
              "the number of another point");
    begin().insert(positions.begin(), positions.end());
  }

  History<Dimension> history_;
  std::vector<Points> states_ = {{}};
  std::size_t at_ = 0;
};

/// Insertions and deletions, in trials and for good.
template <int Dimension>
class Trying : public Operations<Dimension> {
 public:
  using Base = Operations<Dimension>;
  using Base::Base;
  using typename Base::Points;

  void run() {
    while (left_ > 0 && !bytes_.empty()) operate(0);
    Base::require_rebuilt(tessellation_, points_);
  }

 private:
  using Base::bytes_;

  void operate(int depth) {
    --left_;
    switch (bytes_.below(8)) {
      case 0:
      case 1:
        if (depth < 4) attempt(depth);
        return;
      case 2:
      case 3:
        if (!points_.empty()) {
          const PointId p = Base::any_there(tessellation_);
          points_.erase(tessellation_.position(p));
          tessellation_.remove(p);
        }
        break;
      case 4: {
        const auto positions = Base::some_positions();
        tessellation_.add_all(positions);
        points_.insert(positions.begin(), positions.end());
        break;
      }
      case 5:
        return Base::query(tessellation_, points_);
      default: {
        const auto p = Base::any_position();
        tessellation_.add(p, Base::any_hint());
        points_.insert(p);
      }
    }
    Base::require_sound(tessellation_, points_);
  }

  void attempt(int depth) {
    const Bits before = bits_of(tessellation_.structure());
    const Points points = points_;
    {
      const Trial<Dimension> trial(tessellation_, changes_[bytes_.below(2)]);
      for (std::size_t steps = bytes_.below(10); steps > 0 && left_ > 0; --steps)
        operate(depth + 1);
    }
    points_ = points;
    require(bits_of(tessellation_.structure()) == before, "a trial leaves something behind");
  }

  Tessellation<Dimension> tessellation_;
  std::array<typename Trial<Dimension>::Changes, 2> changes_;
  Points points_;
  std::size_t left_ = longest_run;
};

}  // namespace

void fuzz_operations(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  switch (bytes.below(4)) {
    case 0:
      return Undoing<2>(bytes).run();
    case 1:
      return Undoing<3>(bytes).run();
    case 2:
      return Trying<2>(bytes).run();
    default:
      return Trying<3>(bytes).run();
  }
}

}  // namespace thiessen::fuzzers
