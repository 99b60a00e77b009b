#include "map/ink/scanline.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace thiessen {
namespace {

constexpr int side = 40;

/// Where a pixel's centre is against the ring, exactly; coordinates are whole quarters, so that
/// every product below is a small whole number.
enum class Where { inside, outside, on_crossing };

Where where(const std::vector<Ring>& rings, int column, int row) {
  const auto eighths = [](double v) { return static_cast<long long>(std::llround(v * 8)); };
  const long long cx = 8 * column + 4;
  const long long cy = 8 * row + 4;
  bool inside = false;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Point a = ring[i];
      Point b = ring[(i + 1) % ring.size()];
      if (b.y < a.y) std::swap(a, b);
      if (eighths(a.y) > cy || eighths(b.y) <= cy) continue;
      const long long rise = eighths(b.y) - eighths(a.y);
      const long long along = (cy - eighths(a.y)) * (eighths(b.x) - eighths(a.x));
      const long long across = (cx - eighths(a.x)) * rise;
      if (along == across) return Where::on_crossing;
      if (along < across) inside = !inside;
    }
  }
  return inside ? Where::inside : Where::outside;
}

Ring random_ring(std::mt19937& random, int vertices) {
  std::uniform_int_distribution<int> quarter(-40, 4 * side + 40);
  Ring ring;
  for (int i = 0; i < vertices; ++i) ring.push_back({quarter(random) / 4.0, quarter(random) / 4.0});
  return ring;
}

TEST(Scanline, fills_the_pixels_whose_centre_is_inside) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937 random(seed);
    std::vector<Ring> rings;
    for (unsigned i = 0; i <= seed % 3; ++i)
      rings.push_back(random_ring(random, 3 + static_cast<int>(seed % 9)));
    OwnerRaster raster(side, side);
    raster.fill(rings, 7);
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        const Where exact = where(rings, column, row);
        if (exact == Where::on_crossing) continue;
        ASSERT_EQ(raster.at(column, row) == 7, exact == Where::inside)
            << "seed " << seed << ", pixel " << column << ", " << row;
      }
    }
  }
}

/// A lattice whose inner nodes are moved at random, too little to turn a triangle over, its fields
/// cut into triangles.
std::vector<Ring> triangles(std::mt19937& random, int fields, double size) {
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  const double step = size / fields;
  std::vector<std::vector<Point>> nodes;
  for (int i = 0; i <= fields; ++i) {
    nodes.emplace_back();
    for (int j = 0; j <= fields; ++j) {
      const bool inner = i > 0 && j > 0 && i < fields && j < fields;
      const double dx = inner ? shift(random) : 0;
      const double dy = inner ? shift(random) : 0;
      nodes.back().push_back({(i + dx) * step, (j + dy) * step});
    }
  }
  std::vector<Ring> result;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    for (std::size_t j = 0; j + 1 < nodes.size(); ++j) {
      const std::array<Point, 4> p{nodes[i][j], nodes[i + 1][j], nodes[i + 1][j + 1],
                                   nodes[i][j + 1]};
      result.push_back({p[0], p[1], p[2]});
      result.push_back({p[3], p[0], p[2]});
    }
  }
  return result;
}

TEST(Scanline, cells_that_share_edges_own_every_pixel_once) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::mt19937 random(seed);
    constexpr int width = 131;
    std::vector<int> owners(width * width, 0);
    for (const Ring& ring : triangles(random, 1 + static_cast<int>(seed), width)) {
      OwnerRaster raster(width, width);
      raster.fill(std::span(&ring, 1), 0);
      for (std::size_t i = 0; i < owners.size(); ++i) owners[i] += raster.owners()[i] == 0 ? 1 : 0;
    }
    for (const int count : owners) ASSERT_EQ(count, 1) << "seed " << seed;
  }
}

TEST(Scanline, edges_through_pixel_centres_give_each_pixel_to_one_side) {
  const std::array<Ring, 2> halves{Ring{{0, 0}, {2.5, 0}, {2.5, 4}, {0, 4}},
                                   Ring{{2.5, 0}, {5, 0}, {5, 4}, {2.5, 4}}};
  OwnerRaster raster(5, 4);
  raster.fill(std::span(halves).first(1), 1);
  raster.fill(std::span(halves).last(1), 2);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 5; ++column) {
      EXPECT_EQ(raster.at(column, row), column < 2 ? 1 : 2);
    }
  }
}

TEST(Scanline, holes_and_parts_outside_stay_empty) {
  const std::array<Ring, 2> rings{Ring{{-100, -100}, {100, -100}, {100, 100}, {-100, 100}},
                                  Ring{{3, 3}, {3, 6}, {6, 6}, {6, 3}}};
  OwnerRaster raster(200, 10);
  raster.fill(rings, 3);
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 200; ++column) {
      const bool hole = column >= 3 && column < 6 && row >= 3 && row < 6;
      EXPECT_EQ(raster.at(column, row), hole || column >= 100 ? OwnerRaster::nobody : 3);
    }
  }
}

}  // namespace
}  // namespace thiessen
