#include "tessellation/cell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "geometry/determinants.h"
#include "geometry/seeded.h"
#include "tessellation/simplices.h"

namespace thiessen {
namespace {

template <int Dimension>
auto cell_at(const Tessellation<Dimension>& tessellation, const PositionIn<Dimension>& position) {
  return find_cell(tessellation, tessellation.find(position).value());
}

std::vector<Point> centres(const PlaneCell& cell) {
  std::vector<Point> centres;
  for (const auto& vertex : cell.vertices) centres.push_back(vertex.centre);
  return centres;
}
std::vector<Point> neighbours(const Tessellation<2>& tessellation, const PlaneCell& cell) {
  std::vector<Point> neighbours;
  for (const PointId q : cell.neighbours) neighbours.push_back(tessellation.position(q));
  return neighbours;
}

std::vector<Point> lattice(double x_step, double y_step, Point origin) {
  std::vector<Point> points;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) points.push_back({origin.x + i * x_step, origin.y + j * y_step});
  }
  return points;
}

TEST(PlaneCell, of_a_lattice_is_a_rectangle_whose_corners_are_said_once) {
  const auto tessellation = tessellation_of<2>(lattice(1, 2, {0, 0}));
  const PlaneCell cell = cell_at<2>(tessellation, {2, 4});
  EXPECT_TRUE(cell.is_bounded);
  EXPECT_EQ(cell.area, 2);
  EXPECT_EQ(centres(cell), (std::vector<Point>{{1.5, 3}, {2.5, 3}, {2.5, 5}, {1.5, 5}}));
  // The edge that ends at a vertex is its neighbour's.
  EXPECT_EQ(neighbours(tessellation, cell), (std::vector<Point>{{1, 4}, {2, 2}, {3, 4}, {2, 6}}));
  EXPECT_TRUE(cell.rays.empty());
}

TEST(PlaneCell, names_a_corner_by_the_simplex_whose_points_come_first) {
  const auto tessellation = tessellation_of<2>(lattice(1, 1, {0, 0}));
  const auto forming = [&](VertexId v) {
    std::set<Point> positions;
    for (const PointId p : tessellation.topology().forming(v))
      positions.insert(tessellation.position(p));
    return positions;
  };
  const PlaneCell cell = cell_at<2>(tessellation, {2, 2});
  Star<2> star;
  tessellation.find_star(cell.point, star);
  ASSERT_GT(star.vertices().size(), 4u);
  for (const VertexId v : star.vertices()) {
    // The middle of the square that the triangle is half of.
    const auto points = forming(v);
    const Point first = *points.begin();
    const Point last = *points.rbegin();
    const double low = std::min({first.y, last.y, std::next(points.begin())->y});
    const auto corner = std::find_if(cell.vertices.begin(), cell.vertices.end(), [&](auto& vertex) {
      return vertex.centre == Point{first.x + 0.5, low + 0.5};
    });
    ASSERT_NE(corner, cell.vertices.end());
    EXPECT_LE(forming(corner->vertex), points);
    EXPECT_EQ(forming(corner->vertex).count({2, 2}), 1u);
  }
}

TEST(PlaneCell, of_points_one_ulp_apart_has_its_area_to_every_digit) {
  const auto tessellation = tessellation_of<2>(lattice(0x1p-52, 0x1p-52, {1, 1}));
  EXPECT_EQ(cell_at<2>(tessellation, {1 + 0x1p-51, 1 + 0x1p-51}).area, 0x1p-104);
}

TEST(PlaneCell, that_is_a_needle_has_its_area_to_every_digit) {
  const double thin = 0x1p-20;
  const double wide = 0x1p20;
  // At right angles, along (3, 4) and (-4, 3), which are 5 long.
  const auto tessellation = tessellation_of<2>({{0, 0},
                                                {3 * thin, 4 * thin},
                                                {-3 * thin, -4 * thin},
                                                {-4 * wide, 3 * wide},
                                                {4 * wide, -3 * wide}});
  EXPECT_DOUBLE_EQ(cell_at<2>(tessellation, {0, 0}).area, 25);
}

TEST(PlaneCell, on_the_hull_runs_from_ray_to_ray) {
  const auto tessellation = tessellation_of<2>(lattice(1, 2, {0, 0}));
  const PlaneCell edge = cell_at<2>(tessellation, {2, 0});
  EXPECT_FALSE(edge.is_bounded);
  EXPECT_TRUE(std::isinf(edge.area));
  EXPECT_EQ(centres(edge), (std::vector<Point>{{2.5, 1}, {1.5, 1}}));
  EXPECT_EQ(neighbours(tessellation, edge), (std::vector<Point>{{3, 0}, {2, 2}, {1, 0}}));
  ASSERT_EQ(edge.rays.size(), 2u);
  EXPECT_EQ(edge.rays[0].from, 0u);
  EXPECT_EQ(edge.rays[0].direction, (Point{0, -1}));
  EXPECT_EQ(edge.rays[1].from, 1u);
  EXPECT_EQ(edge.rays[1].direction, (Point{0, -1}));

  const PlaneCell corner = cell_at<2>(tessellation, {4, 8});
  EXPECT_EQ(centres(corner), (std::vector<Point>{{3.5, 7}}));
  EXPECT_EQ(neighbours(tessellation, corner), (std::vector<Point>{{3, 8}, {4, 6}}));
  EXPECT_EQ(corner.rays[0].direction, (Point{0, 1}));
  EXPECT_EQ(corner.rays[1].direction, (Point{1, 0}));
}

TEST(PlaneCell, of_fewer_dimensions_has_neighbours_alone) {
  const auto alone = tessellation_of<2>({{1, 2}});
  EXPECT_TRUE(cell_at<2>(alone, {1, 2}).neighbours.empty());
  EXPECT_TRUE(std::isinf(cell_at<2>(alone, {1, 2}).area));
  const auto line = tessellation_of<2>({{3, 3}, {1, 1}, {7, 7}, {4, 4}});
  const PlaneCell strip = cell_at<2>(line, {4, 4});
  EXPECT_EQ(neighbours(line, strip), (std::vector<Point>{{3, 3}, {7, 7}}));
  EXPECT_TRUE(strip.vertices.empty());
  EXPECT_FALSE(strip.is_bounded);
  EXPECT_EQ(neighbours(line, cell_at<2>(line, {7, 7})), (std::vector<Point>{{4, 4}}));
}

/// Points of a unit torus, so fine that its copies are exact, and the copies round it.
template <int Dimension>
std::vector<PositionIn<Dimension>> torus(Seeded& seeded, std::size_t count) {
  const auto coordinate = [&] { return static_cast<double>(seeded.below(1u << 30)) * 0x1p-30; };
  std::vector<PositionIn<Dimension>> points;
  for (std::size_t i = 0; i < count; ++i) {
    if constexpr (Dimension == 2) {
      points.push_back({coordinate(), coordinate()});
    } else {
      points.push_back({coordinate(), coordinate(), coordinate()});
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto p = points[i];
    for (int copy = 0; copy < (Dimension == 2 ? 9 : 27); ++copy) {
      const double right = copy % 3 - 1;
      const double up = copy / 3 % 3 - 1;
      if (copy == (Dimension == 2 ? 4 : 13)) continue;
      if constexpr (Dimension == 2) {
        points.push_back({p.x + right, p.y + up});
      } else {
        points.push_back({p.x + right, p.y + up, p.z + copy / 9 - 1});
      }
    }
  }
  return points;
}

double area_of_vertices(const PlaneCell& cell, Point p) {
  double doubled = 0;
  for (std::size_t i = 0; i < cell.vertices.size(); ++i) {
    const Point v = cell.vertices[i].centre;
    const Point w = cell.vertices[(i + 1) % cell.vertices.size()].centre;
    doubled += (v.x - p.x) * (w.y - p.y) - (v.y - p.y) * (w.x - p.x);
  }
  return doubled / 2;
}

// Of a homogeneous Poisson process: 6 sides, and the area's variance is 0.2802 of its square.
TEST(PlaneCell, of_a_random_sample_has_the_known_statistics) {
  Seeded seeded;
  const std::size_t count = 20000 * seeded.rounds(1);
  const auto points = torus<2>(seeded, count);
  Tessellation<2> tessellation;
  const auto ids = tessellation.add_all(points);
  double area = 0;
  double squares = 0;
  std::size_t sides = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const PlaneCell cell = find_cell(tessellation, ids[i]);
    ASSERT_TRUE(cell.is_bounded);
    ASSERT_EQ(cell.vertices.size(), cell.neighbours.size());
    ASSERT_NEAR(area_of_vertices(cell, points[i]), cell.area, 1e-9 * cell.area);
    area += cell.area;
    squares += cell.area * cell.area;
    sides += cell.neighbours.size();
  }
  const auto n = static_cast<double>(count);
  EXPECT_NEAR(area, 1, 1e-12);
  EXPECT_EQ(sides, 6 * count);  // Euler's relation on a torus
  // The areas' fourth moment is near that of a gamma distribution: 3 + 6 * 0.28.
  EXPECT_NEAR(squares * n - 1, 0.2802, 5 * 0.2802 * std::sqrt(3.68 / n));
}

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

// Whatever was added, deleted and undone before.
TEST(Cells, depend_on_the_points_alone) {
  Seeded seeded;
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) {
    points.push_back(
        {static_cast<double>(seeded.below(20)), static_cast<double>(seeded.below(20))});
  }
  const auto first = tessellation_of<2>(points);
  std::shuffle(points.begin(), points.end(), seeded.generator());
  Tessellation<2> second;
  for (const Point p : points) second.add(p);
  first.for_each_point([&](PointId p) {
    const PlaneCell cell = find_cell(first, p);
    const PlaneCell other = cell_at<2>(second, first.position(p));
    EXPECT_EQ(centres(cell), centres(other));
    EXPECT_EQ(neighbours(first, cell), neighbours(second, other));
    EXPECT_EQ(cell.area, other.area);
  });
}

}  // namespace
}  // namespace thiessen
