#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <span>
#include <vector>

#include "base/interrupt.h"
#include "tessellation/audit.h"
#include "tessellation/cell.h"
#include "tessellation/session.h"
#include "tessellation/topology_table.h"

namespace thiessen {
namespace {

/// Ctrl-C has come before the work begins; what hears it at all hears it then.
class Interruption : public ::testing::Test {
 protected:
  void SetUp() override { watch_for_interrupts(); }
  void TearDown() override { forget_interrupt(); }

  template <typename Work>
  static bool is_heard(Work&& work) {
    std::raise(SIGINT);
    bool heard = false;
    try {
      work();
    } catch (const Interrupted&) {
      heard = true;
    }
    forget_interrupt();
    return heard;
  }
};

/// A point with so many neighbours that its deletion and its cell are long work.
std::vector<SpacePoint> hub() {
  std::vector<SpacePoint> points{{0, 0, 0}};
  for (int i = 0; i < 100; ++i) {
    const double z = (i - 49.5) / 50;
    const double across = std::sqrt(1 - z * z);
    points.push_back({across * std::cos(2.4 * i), across * std::sin(2.4 * i), z});
  }
  return points;
}

TEST_F(Interruption, is_heard_by_long_work) {
  const std::vector<SpacePoint> points = hub();
  Tessellation<3> tessellation;
  EXPECT_TRUE(is_heard([&] { Tessellation<3>().add_all(points); }));
  EXPECT_TRUE(is_heard([&] { Tessellation<2>().add_all(std::vector<Point>{{1, 2}, {3, 4}}); }));
  tessellation.add_all(points);
  const PointId middle = *tessellation.find({0, 0, 0});
  EXPECT_TRUE(is_heard([&] { audit(tessellation); }));
  EXPECT_TRUE(is_heard([&] { find_cell(tessellation, middle); }));
  const SpaceCell cell = find_cell(tessellation, middle);
  EXPECT_TRUE(is_heard([&] {
    cell_text(
        tessellation, [](PointId p) { return index(p); }, cell);
  }));
}

// Load and delete leave the session as it was, and what was undone can be redone.
TEST_F(Interruption, leaves_a_session_as_it_was) {
  const std::vector<SpacePoint> points = hub();
  TessellationSession<3> session;
  session.add_all(points);
  session.add({3, 3, 3});
  session.undo();
  EXPECT_TRUE(is_heard([&] { session.remove({0, 0, 0}); }));
  EXPECT_TRUE(is_heard([&] { session.add_all(std::vector<SpacePoint>{{5, 5, 5}}); }));
  EXPECT_TRUE(is_heard([&] { session.add_all(std::vector<SpacePoint>(300, {6, 6, 6})); }));
  EXPECT_EQ(session.tessellation().count(), 101u);
  EXPECT_TRUE(audit(session.tessellation()).empty());
  session.redo();
  EXPECT_EQ(session.number_of(session.point_at({3, 3, 3})), 102u);
}

}  // namespace
}  // namespace thiessen
