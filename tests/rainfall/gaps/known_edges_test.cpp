#include "rainfall/gaps/known_edges.h"

#include <gtest/gtest.h>

#include <vector>

#include "basin/shapes.h"

namespace thiessen {
namespace {

/// Figures by hand: how far an edge goes east, and its bulge. Counts how often it is asked.
class EastwardWay : public GroundMeasure {
 public:
  std::size_t figures() const override { return 2; }
  void add(Point from, Point to, double bulge, std::span<double> figures) const override {
    figures[0] += to.x - from.x;
    figures[1] += bulge;
    ++asked;
  }
  mutable int asked = 0;
};

/// A rectangle with a hole; edges have bulges of their own, and one has no length.
Basin pierced() {
  Basin basin =
      shapes::basin({{{{0, 0}, {8, 0}, {8, 0}, {8, 4}, {0, 4}}, {{{2, 1}, {2, 2}, {3, 1}}}}});
  basin.bulges = {{1, 0, 2, 3, 4}, {5, 6, 7}};
  return basin;
}

struct Known {
  Basin ground = pierced();
  EastwardWay measure;
  std::vector<double> figures = figures_of_edges(ground, measure);
  KnownEdges edges{ground, figures, measure};

  Known() { measure.asked = 0; }
  std::vector<double> of(Point from, Point to, double bulge) {
    std::vector<double> found(2, 0);
    edges.add(from, to, bulge, found);
    return found;
  }
};

TEST(KnownEdges, have_the_figures_of_each_edge_in_turn) {
  const Known known;
  const std::vector<double> expected{8, 1, 0, 0, 0, 2, -8, 3, 0, 4, 0, 5, 1, 6, -1, 7};
  EXPECT_EQ(known.figures, expected);
}

TEST(KnownEdges, that_are_whole_are_not_measured_again) {
  Known known;
  EXPECT_EQ(known.of({0, 0}, {8, 0}, 1), (std::vector<double>{8, 1}));
  EXPECT_EQ(known.of({8, 0}, {8, 4}, 2), (std::vector<double>{0, 2}));
  EXPECT_EQ(known.of({8, 4}, {0, 4}, 3), (std::vector<double>{-8, 3}));
  EXPECT_EQ(known.of({0, 4}, {0, 0}, 4), (std::vector<double>{0, 4}));
  EXPECT_EQ(known.of({2, 1}, {2, 2}, 5), (std::vector<double>{0, 5}));
  EXPECT_EQ(known.measure.asked, 0);
}

// The first edge is cut in two and the next in three; the others are known again.
TEST(KnownEdges, that_are_cut_are_measured_piece_by_piece) {
  Known known;
  EXPECT_EQ(known.of({0, 0}, {3, 0}, 0.25), (std::vector<double>{3, 0.25}));
  EXPECT_EQ(known.of({3, 0}, {8, 0}, 0.75), (std::vector<double>{5, 0.75}));
  EXPECT_EQ(known.of({8, 0}, {8, 1}, 0.5), (std::vector<double>{0, 0.5}));
  EXPECT_EQ(known.of({8, 1}, {8, 3}, 1), (std::vector<double>{0, 1}));
  EXPECT_EQ(known.of({8, 3}, {8, 4}, 0.5), (std::vector<double>{0, 0.5}));
  EXPECT_EQ(known.measure.asked, 5);
  EXPECT_EQ(known.of({8, 4}, {0, 4}, 3), (std::vector<double>{-8, 3}));
  EXPECT_EQ(known.of({0, 4}, {0, 0}, 4), (std::vector<double>{0, 4}));
  EXPECT_EQ(known.measure.asked, 5);
}

TEST(KnownEdges, that_run_backwards_or_come_out_of_turn_are_measured) {
  Known known;
  EXPECT_EQ(known.of({2, 1}, {2, 2}, 5), (std::vector<double>{0, 5}));
  EXPECT_EQ(known.of({8, 0}, {0, 0}, -1), (std::vector<double>{-8, -1}));
  EXPECT_EQ(known.measure.asked, 2);
}

}  // namespace
}  // namespace thiessen
