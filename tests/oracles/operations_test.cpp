// Random insertions, deletions, undos, redos and trials, through every span, down to nothing and up
// again (T007, T029). After every batch the tessellation is audited, is that of the same points
// built from scratch in another order, simplex for simplex, and is CGAL's up to ties.
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/same_as_cgal.h"
#include "tessellation/history.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

template <int Dimension>
class Operations {
 public:
  using Position = PositionIn<Dimension>;

  /// Of points out of `pool`.
  Operations(Seeded& seeded, const std::vector<Position>& pool) : seeded_(seeded), pool_(pool) {}
  virtual ~Operations() = default;
  Operations(const Operations&) = delete;
  Operations& operator=(const Operations&) = delete;

  virtual const Tessellation<Dimension>& tessellation() const = 0;
  /// Of the operations that changed something.
  std::uint64_t count() const { return count_; }

  /// More insertions than deletions, fewer, or deletions until nothing is left.
  void run_batch() {
    const std::uint64_t kind = seeded_.below(4);
    const std::uint64_t deletions = kind == 0 ? 3 : kind == 1 ? 5 : kind == 2 ? 6 : 10;
    const std::uint64_t steps = seeded_.below(2 * pool_.size() + 4);
    for (std::uint64_t step = 0; step < steps; ++step) {
      operate(deletions);
      if (testing::Test::HasFailure()) return;
    }
  }

  void check(bool against_cgal) {
    const std::vector<Position> points(there_.begin(), there_.end());
    ASSERT_EQ(positions_of(tessellation()), points);
    const auto findings = audit(tessellation());
    ASSERT_TRUE(findings.empty()) << name_of(findings.front().fault);
    std::vector<Position> shuffled = points;
    std::shuffle(shuffled.begin(), shuffled.end(), seeded_.generator());
    const Tessellation<Dimension> rebuilt = tessellation_of(shuffled);
    ASSERT_EQ(tessellation().span(), rebuilt.span());
    ASSERT_TRUE(plain_simplices(tessellation()) == plain_simplices(rebuilt));
    if (against_cgal) expect_same_as_cgal(tessellation());
  }

 protected:
  virtual void operate(std::uint64_t deletions_of_ten) = 0;

  const Position& any_of_pool() { return pool_[seeded_.below(pool_.size())]; }
  /// One at random, or the first or last by coordinates, which is on the hull.
  PointId any_there() {
    const std::uint64_t choice = seeded_.below(8);
    if (choice < 2) return *tessellation().find(choice == 0 ? *there_.begin() : *there_.rbegin());
    for (;;) {
      const PointId p{
          static_cast<std::uint32_t>(seeded_.below(tessellation().topology().point_limit()))};
      if (tessellation().is_there(p)) return p;
    }
  }
  std::optional<PointId> any_hint() {
    if (seeded_.below(2) == 0) return {};
    return PointId{
        static_cast<std::uint32_t>(seeded_.below(tessellation().topology().point_limit() + 2))};
  }

  Seeded& seeded_;
  const std::vector<Position>& pool_;
  std::set<Position> there_;
  std::uint64_t count_ = 0;
};

/// With undo and redo.
template <int Dimension>
class OperationsOfHistory : public Operations<Dimension> {
 public:
  using Operations<Dimension>::Operations;
  const Tessellation<Dimension>& tessellation() const override { return history_.tessellation(); }

 private:
  using Base = Operations<Dimension>;
  using Base::seeded_;
  using Base::there_;
  using typename Base::Position;

  /// What the operation added and took away.
  struct Step {
    std::vector<Position> added;
    std::vector<Position> removed;
  };

  void operate(std::uint64_t deletions_of_ten) override {
    const std::uint64_t choice = seeded_.below(20);
    if (choice < 3) {
      undo();
    } else if (choice < 5) {
      redo();
    } else if (choice == 5) {
      add_many();
    } else if (seeded_.below(10) < deletions_of_ten && !there_.empty()) {
      const PointId p = this->any_there();
      const Position position = tessellation().position(p);
      history_.remove(p);
      record({{}, {position}});
    } else {
      const Position p = this->any_of_pool();
      const PointId number = history_.add(p, this->any_hint());
      ASSERT_EQ(tessellation().position(number), p);
      record(there_.count(p) == 0 ? Step{{p}, {}} : Step{});
    }
  }

  void add_many() {
    std::vector<Position> points(seeded_.below(6));
    for (Position& p : points) p = this->any_of_pool();
    history_.add_all(points);
    Step step;
    for (const Position& p : points) {
      if (there_.count(p) == 0) step.added.push_back(p);
    }
    record(std::move(step));
  }
  void record(Step step) {
    apply(step.added, step.removed);
    steps_.resize(done_);
    steps_.push_back(std::move(step));
    ++done_;
    ASSERT_EQ(history_.undoable(), done_);
  }
  void undo() {
    ASSERT_EQ(history_.undo(), done_ > 0);
    if (done_ == 0) return;
    --done_;
    apply(steps_[done_].removed, steps_[done_].added);
  }
  void redo() {
    ASSERT_EQ(history_.redo(), done_ < steps_.size());
    if (done_ == steps_.size()) return;
    apply(steps_[done_].added, steps_[done_].removed);
    ++done_;
  }
  void apply(const std::vector<Position>& add, const std::vector<Position>& remove) {
    if (!add.empty() || !remove.empty()) ++Base::count_;
    for (const Position& p : add) there_.insert(p);
    for (const Position& p : remove) there_.erase(p);
  }

  History<Dimension> history_;
  std::vector<Step> steps_;
  std::size_t done_ = 0;
};

/// With trials, nested ones among them.
template <int Dimension>
class OperationsOfTrial : public Operations<Dimension> {
 public:
  using Operations<Dimension>::Operations;
  const Tessellation<Dimension>& tessellation() const override { return tessellation_; }

 private:
  using Base = Operations<Dimension>;
  using Base::seeded_;
  using Base::there_;

  void operate(std::uint64_t deletions_of_ten) override {
    if (seeded_.below(10) == 0) {
      attempt(0);
    } else {
      change(deletions_of_ten);
    }
  }

  void change(std::uint64_t deletions_of_ten) {
    if (seeded_.below(10) < deletions_of_ten && !there_.empty()) {
      const PointId p = this->any_there();
      there_.erase(tessellation_.position(p));
      tessellation_.remove(p);
      ++Base::count_;
    } else {
      const auto& p = this->any_of_pool();
      tessellation_.add(p, this->any_hint());
      if (there_.insert(p).second) ++Base::count_;
    }
  }

  void attempt(int depth) {
    const Bits before = bits_of(tessellation_.structure());
    const auto there = there_;
    {
      const Trial<Dimension> trial(tessellation_, changes_);
      const std::uint64_t steps = seeded_.below(8);
      for (std::uint64_t i = 0; i < steps; ++i) {
        if (depth < 2 && seeded_.below(8) == 0) {
          attempt(depth + 1);
        } else {
          change(5);
        }
      }
    }
    there_ = there;
    ASSERT_EQ(bits_of(tessellation_.structure()), before);
  }

  Tessellation<Dimension> tessellation_;
  typename Trial<Dimension>::Changes changes_;
};

template <int Dimension, template <int> class Kind>
std::uint64_t run(Seeded& seeded, const FamilyIn<Dimension>& family) {
  SCOPED_TRACE(family.name);
  Kind<Dimension> operations(seeded, family.points);
  for (int batch = 0; batch < 4; ++batch) {
    operations.run_batch();
    operations.check(batch % 2 == 0);
    if (testing::Test::HasFailure()) break;
  }
  return operations.count();
}

std::uint64_t first_seed() {
  std::uint64_t seed = 1;
  if (const char* text = std::getenv("THIESSEN_SEED")) {
    const std::string_view digits(text);
    std::from_chars(digits.data(), digits.data() + digits.size(), seed);
  }
  return seed;
}

// Round after round, each with a seed of its own, so that a failure is there again in its first.
template <int Dimension>
void run_rounds(std::uint64_t usual) {
  Seeded seeded;
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t first = first_seed();
  const std::uint64_t rounds = Seeded::rounds(usual);
  std::uint64_t count = 0;
  std::uint64_t reported = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const std::uint64_t seed = first + round;
    SCOPED_TRACE("again, at once: THIESSEN_SEED=" + std::to_string(seed));
    seeded.generator().seed(seed);
    const std::size_t size = round % 16 == 15 ? 150 : 4 + seeded.below(30);
    for (const FamilyIn<Dimension>& family : families::all_in<Dimension>(seeded, size)) {
      if (size < 100 && family.points.size() > 100) continue;
      count += seeded.below(2) == 0 ? run<Dimension, OperationsOfHistory>(seeded, family)
                                    : run<Dimension, OperationsOfTrial>(seeded, family);
      if (testing::Test::HasFailure()) return;
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    if (count / 500000 == reported && round + 1 < rounds) continue;
    reported = count / 500000;
    if (rounds == usual) continue;
    std::printf("%d-D: %llu operations in %.0f s, seeds %llu to %llu\n", Dimension,
                static_cast<unsigned long long>(count), passed.count(),
                static_cast<unsigned long long>(first), static_cast<unsigned long long>(seed));
    std::fflush(stdout);
  }
  testing::Test::RecordProperty("operations", std::to_string(count));
}

TEST(Operations, in_the_plane) {
  run_rounds<2>(48);
}

TEST(Operations, in_space) {
  run_rounds<3>(32);
}

}  // namespace
}  // namespace thiessen
