#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "geometry/determinants.h"
#include "tessellation/cells_of_points.h"

namespace thiessen {
namespace {

using Vector = SpaceVector<double>;

Vector between(const SpacePoint& from, const SpacePoint& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

double volume_of_vertices(const SpaceCell& cell, const SpacePoint& p) {
  double volume = 0;
  for (const CellFace& face : cell.faces) {
    const Vector u = between(p, cell.vertices[face.vertices[0]].centre);
    for (std::size_t i = 1; i + 1 < face.vertices.size(); ++i) {
      const Vector v = between(p, cell.vertices[face.vertices[i]].centre);
      const Vector w = between(p, cell.vertices[face.vertices[i + 1]].centre);
      volume += determinant::volume(u, v, w) / 6;  // positive: counter-clockwise from outside
    }
  }
  return volume;
}

// 48 pi^2 / 35 + 2 = 15.5355 faces, of variance 11.1; the volume's variance is 0.1790.
TEST(SpaceCell, of_a_random_sample_has_the_known_statistics) {
  Seeded seeded;
  const std::size_t count = 2000 * seeded.rounds(1);
  const auto points = torus<3>(seeded, count);
  Tessellation<3> tessellation;
  const auto ids = tessellation.add_all(points);
  double volume = 0;
  double squares = 0;
  double faces = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const SpaceCell cell = find_cell(tessellation, ids[i]);
    ASSERT_TRUE(cell.is_bounded);
    ASSERT_EQ(cell.vertices.size(), 2 * cell.faces.size() - 4);  // three edges at every vertex
    ASSERT_NEAR(volume_of_vertices(cell, points[i]), cell.volume, 1e-9 * cell.volume);
    volume += cell.volume;
    squares += cell.volume * cell.volume;
    faces += static_cast<double>(cell.faces.size());
  }
  const auto n = static_cast<double>(count);
  EXPECT_NEAR(volume, 1, 1e-12);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(faces / n, 48 * pi * pi / 35 + 2, 5 * std::sqrt(11.1 / n));
  EXPECT_NEAR(squares * n - 1, 0.1790, 5 * 0.1790 * std::sqrt((2 + 6 * 0.179) / n));
}

/// The points of a cube of the whole-number lattice that `keep` says.
template <typename Keep>
std::vector<SpacePoint> space_lattice(int half, Keep keep) {
  std::vector<SpacePoint> points;
  for (int x = -half; x <= half; ++x) {
    for (int y = -half; y <= half; ++y) {
      for (int z = -half; z <= half; ++z) {
        if (keep(x, y, z)) points.push_back({double(x), double(y), double(z)});
      }
    }
  }
  return points;
}

std::multiset<std::size_t> corners_of_faces(const SpaceCell& cell) {
  std::multiset<std::size_t> corners;
  for (const CellFace& face : cell.faces) corners.insert(face.vertices.size());
  return corners;
}

TEST(SpaceCell, of_the_lattices_is_the_solid_that_it_is_known_for) {
  const auto all = tessellation_of<3>(space_lattice(2, [](int, int, int) { return true; }));
  const SpaceCell cube = cell_at<3>(all, {0, 0, 0});
  EXPECT_EQ(corners_of_faces(cube), (std::multiset<std::size_t>{4, 4, 4, 4, 4, 4}));
  EXPECT_EQ(cube.vertices.size(), 8u);
  EXPECT_EQ(cube.volume, 1);
  for (const CellFace& face : cube.faces) EXPECT_DOUBLE_EQ(face.area, 1);

  // Face-centred: a rhombic dodecahedron of volume 2.
  const auto face_centred = tessellation_of<3>(
      space_lattice(3, [](int x, int y, int z) { return (x + y + z) % 2 == 0; }));
  const SpaceCell rhombic = cell_at<3>(face_centred, {0, 0, 0});
  EXPECT_EQ(corners_of_faces(rhombic),
            std::multiset<std::size_t>({4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4}));
  EXPECT_EQ(rhombic.vertices.size(), 14u);
  EXPECT_EQ(rhombic.volume, 2);
  for (const CellFace& face : rhombic.faces) EXPECT_DOUBLE_EQ(face.area, std::sqrt(0.5));

  // Body-centred: a truncated octahedron of volume 4.
  const auto body_centred = tessellation_of<3>(
      space_lattice(4, [](int x, int y, int z) { return (x - y) % 2 == 0 && (y - z) % 2 == 0; }));
  const SpaceCell truncated = cell_at<3>(body_centred, {0, 0, 0});
  EXPECT_EQ(corners_of_faces(truncated),
            std::multiset<std::size_t>({4, 4, 4, 4, 4, 4, 6, 6, 6, 6, 6, 6, 6, 6}));
  EXPECT_EQ(truncated.vertices.size(), 24u);
  EXPECT_EQ(truncated.volume, 4);
}

TEST(SpaceCell, of_a_cubes_corner_is_an_octant) {
  const auto cube =
      tessellation_of<3>(space_lattice(1, [](int x, int y, int z) { return x * y * z != 0; }));
  const SpaceCell cell = cell_at<3>(cube, {1, -1, 1});
  EXPECT_FALSE(cell.is_bounded);
  EXPECT_TRUE(std::isinf(cell.volume));
  ASSERT_EQ(cell.vertices.size(), 1u);
  EXPECT_EQ(cell.vertices[0].centre, (SpacePoint{0, 0, 0}));
  std::vector<SpacePoint> rays;
  for (const auto& ray : cell.rays) rays.push_back(ray.direction);
  EXPECT_EQ(rays, (std::vector<SpacePoint>{{0, -1, 0}, {0, 0, 1}, {1, 0, 0}}));
  std::vector<SpacePoint> neighbours;
  for (const CellFace& face : cell.faces) {
    EXPECT_FALSE(face.is_bounded);
    EXPECT_EQ(face.vertices, std::vector<std::size_t>{0});
    neighbours.push_back(cube.position(face.neighbour));
  }
  EXPECT_EQ(neighbours, (std::vector<SpacePoint>{{-1, -1, 1}, {1, -1, -1}, {1, 1, 1}}));
}

TEST(SpaceCell, of_fewer_dimensions_has_neighbours_alone) {
  const auto plane = tessellation_of<3>(space_lattice(
      2, [](int x, int y, int z) { return x + y + z == 0 && x % 2 == 0 && y % 2 == 0; }));
  ASSERT_EQ(plane.span(), Span::plane);
  const SpaceCell prism = cell_at<3>(plane, {0, 0, 0});
  EXPECT_EQ(prism.faces.size(), 6u);  // of a hexagonal lattice
  EXPECT_TRUE(prism.vertices.empty());
  EXPECT_FALSE(prism.is_bounded);
  const auto square = tessellation_of<3>(space_lattice(1, [](int, int y, int) { return y == 0; }));
  EXPECT_EQ(cell_at<3>(square, {0, 0, 0}).faces.size(), 4u);
  const auto line = tessellation_of<3>({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}});
  EXPECT_EQ(cell_at<3>(line, {1, 1, 1}).faces.size(), 2u);
  EXPECT_EQ(cell_at<3>(line, {3, 3, 3}).faces.size(), 1u);
  EXPECT_EQ(cell_at<3>(tessellation_of<3>({{1, 2, 3}}), {1, 2, 3}).faces.size(), 0u);
}

/// The face towards a neighbour; none where it is no neighbour.
const CellFace* face_towards(const SpaceCell& cell, PointId q) {
  const auto face = std::find_if(cell.faces.begin(), cell.faces.end(),
                                 [&](const CellFace& f) { return f.neighbour == q; });
  return face == cell.faces.end() ? nullptr : &*face;
}

// Of few whole coordinates, so that most are degenerate.
TEST(SpaceCell, shares_its_faces_with_its_neighbours) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(30); ++round) {
    Tessellation<3> tessellation;
    for (int i = 0; i < 40; ++i) {
      const auto coordinate = [&] { return static_cast<double>(seeded.below(4)); };
      tessellation.add({coordinate(), coordinate(), coordinate()});
    }
    tessellation.for_each_point([&](PointId p) {
      const SpaceCell cell = find_cell(tessellation, p);
      if (cell.is_bounded) {
        EXPECT_NEAR(volume_of_vertices(cell, tessellation.position(p)), cell.volume, 1e-12);
      }
      for (const CellFace& face : cell.faces) {
        const SpaceCell other = find_cell(tessellation, face.neighbour);
        const CellFace* const back = face_towards(other, p);
        ASSERT_NE(back, nullptr);
        EXPECT_EQ(face.is_bounded, back->is_bounded);
        EXPECT_EQ(face.vertices.size(), back->vertices.size());
        if (face.is_bounded) {
          EXPECT_NEAR(face.area, back->area, 1e-12 * face.area);
        }
      }
    });
  }
}

}  // namespace
}  // namespace thiessen
