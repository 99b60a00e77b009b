#include "results/mesh_file.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/version.h"
#include "results/written.h"

namespace thiessen {
namespace {

template <int Dimension>
std::string mesh_of(MeshFormat format, const std::vector<PositionIn<Dimension>>& points) {
  Tessellation<Dimension> tessellation;
  const std::vector<PointId> ids = tessellation.add_all(points);
  const NumberOf number_of = [&](PointId p) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (ids[i] == p) return std::uint64_t{10 * i + 1};
    }
    return std::uint64_t{0};
  };
  return written(
      [&](OutputFile& file) { write_mesh<Dimension>(file, format, tessellation, number_of); });
}

/// A mesh as a reader of OBJ sees it: the corners of its faces, group by group.
struct ObjGroup {
  std::string name;
  std::vector<std::vector<SpacePoint>> faces;
};
std::vector<ObjGroup> read_obj(const std::string& text) {
  std::vector<SpacePoint> vertices;
  std::vector<ObjGroup> groups{{"", {}}};
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      SpacePoint p;
      words >> p.x >> p.y >> p.z;
      vertices.push_back(p);
    } else if (kind == "g") {
      words >> groups.emplace_back().name;
    } else if (kind == "f") {
      auto& face = groups.back().faces.emplace_back();
      for (std::size_t i = 0; words >> i;) face.push_back(vertices.at(i - 1));
    }
  }
  return groups;
}

/// The volume inside faces that are counter-clockwise from outside.
double volume_of(const ObjGroup& group) {
  double sum = 0;
  for (const auto& face : group.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const auto &a = face[0], &b = face[i], &c = face[i + 1];
      sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
             a.z * (b.x * c.y - b.y * c.x);
    }
  }
  return sum / 6;
}

TEST(MeshFile, of_a_triangle_as_geojson) {
  const std::string text = mesh_of<2>(MeshFormat::geojson, {{0, 0}, {4, 0}, {0, 3}});
  EXPECT_TRUE(text.starts_with(R"({"type":"FeatureCollection","made_by":{"software":"thiessen )"));
  EXPECT_NE(text.find(R"("type":"Polygon","coordinates":[[[)"), std::string::npos) << text;
  for (const char* number : {R"(:1)", R"(:11)", R"(:21)"})
    EXPECT_NE(text.find(number), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("]]}}\n]}\n")) << text;
}

TEST(MeshFile, of_a_triangle_as_obj) {
  const auto groups = read_obj(mesh_of<2>(MeshFormat::obj, {{0, 0}, {4, 0}, {0, 3}}));
  ASSERT_EQ(groups.size(), 1U);
  ASSERT_EQ(groups[0].faces.size(), 1U);
  const auto& f = groups[0].faces[0];
  const double doubled =
      (f[1].x - f[0].x) * (f[2].y - f[0].y) - (f[1].y - f[0].y) * (f[2].x - f[0].x);
  EXPECT_EQ(doubled, 12) << "counter-clockwise";
}

TEST(MeshFile, of_a_triangle_as_ply) {
  const std::string text = mesh_of<2>(MeshFormat::ply, {{0, 0}, {4, 0}, {0, 0.5}});
  EXPECT_TRUE(text.starts_with("ply\nformat ascii 1.0\ncomment made by thiessen " +
                               std::string(version()) +
                               "\nelement vertex 3\nproperty double x\nproperty double y\n"
                               "property double z\nproperty uint number\nelement face 1\n"
                               "property list uchar int vertex_indices\nend_header\n"
                               "0 0 0 1\n4 0 0 11\n0 0.5 0 21\n3 "))
      << text;
}

// A cube of 27 points: its tetrahedra fill it, and the middle has the one bounded cell.
TEST(MeshFile, of_a_lattice_in_space_as_obj) {
  std::vector<SpacePoint> points;
  for (int i = 0; i < 27; ++i) points.push_back({2.0 * (i % 3), 2.0 * (i / 3 % 3), 2.0 * (i / 9)});
  double tetrahedra = 0;
  std::size_t cells = 0;
  for (const ObjGroup& group : read_obj(mesh_of<3>(MeshFormat::obj, points))) {
    if (group.name.starts_with("tetrahedron_")) {
      ASSERT_EQ(group.faces.size(), 4U);
      EXPECT_GT(volume_of(group), 0) << group.name;
      tetrahedra += volume_of(group);
    } else if (group.name.starts_with("cell_")) {
      EXPECT_EQ(group.name, "cell_131");
      EXPECT_EQ(group.faces.size(), 6U);
      EXPECT_NEAR(volume_of(group), 8, 1e-12);
      ++cells;
    }
  }
  EXPECT_NEAR(tetrahedra, 64, 1e-12);
  EXPECT_EQ(cells, 1U);
}

TEST(MeshFile, of_a_tetrahedron_as_ply_has_four_faces) {
  const std::string text =
      mesh_of<3>(MeshFormat::ply, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_NE(text.find("element face 4\n"), std::string::npos) << text;
}

TEST(MeshFile, of_points_on_a_line_has_points_alone) {
  EXPECT_TRUE(mesh_of<2>(MeshFormat::geojson, {{0, 0}, {1, 0}}).ends_with("\"features\":[\n]}\n"));
  EXPECT_EQ(mesh_of<2>(MeshFormat::obj, {{0, 0}, {1, 0}}),
            "# made by thiessen " + std::string(version()) + "\no delaunay\nv 0 0 0\nv 1 0 0\n");
}

TEST(MeshFile, format_is_that_of_the_extension) {
  EXPECT_EQ(mesh_format<2>("a.b/m.OBJ"), MeshFormat::obj);
  EXPECT_EQ(mesh_format<3>("m.ply"), MeshFormat::ply);
  EXPECT_EQ(mesh_format<2>("m.geojson"), MeshFormat::geojson);
  EXPECT_NE(complaint_of([] { mesh_format<2>("m.stl"); }).find("m.stl: no format"),
            std::string::npos);
  EXPECT_NE(complaint_of([] { mesh_format<3>("m.geojson"); }).find("GeoJSON has no tetrahedra"),
            std::string::npos);
}

}  // namespace
}  // namespace thiessen
