#include "cli/command_lines.h"

namespace thiessen::cli {
namespace {

TEST(CellsCommand, NeedsStationsAlone) {
  EXPECT_EQ(refusal({"cells"}), "STATIONS is missing");
  EXPECT_EQ(refusal({"cells", "stations"}), "");
}

TEST(CellsCommand, DeclaresOptionsUnderTheirHeadings) {
  EXPECT_EQ(group_of("cells", "--margin"), "Method");
  EXPECT_EQ(group_of("cells", "--time"), "Readings");
  EXPECT_EQ(group_of("cells", "--attributes"), "Output");
}

TEST(CellsCommand, WritesTrianglesAndNeighboursBesideTheCellsOrInTheirPlace) {
  EXPECT_EQ(group_of("cells", "--delaunay"), "Output");
  EXPECT_EQ(group_of("cells", "--neighbours"), "Output");
  EXPECT_EQ(refusal({"cells", "s", "--delaunay", "t.geojson", "--neighbours", "-"}), "");
  EXPECT_EQ(refusal({"cells", "s", "--delaunay", "--neighbours", "-"}),
            "two outputs cannot both be the standard output");
  EXPECT_EQ(refusal({"cells", "s", "--delaunay", "-o", "t.gpkg", "--attributes"}),
            "--attributes carries fields onto cells, and none are written");
}

TEST(CellsCommand, ShowsATimeOfRainfallOnly) {
  EXPECT_EQ(refusal({"cells", "s", "b", "--time", "2013"}), "--time needs RAINFALL");
  EXPECT_EQ(refusal({"cells", "s", "b", "r", "--time", "2013"}), "");
}

TEST(CellsCommand, RefusesAPlaneThatIsGeodesic) {
  EXPECT_EQ(refusal({"cells", "s", "--plane", "EPSG:3035", "--metric", "geodesic"}),
            "--plane is planar, and --metric says geodesic");
  EXPECT_EQ(refusal({"cells", "s", "--plane", "EPSG:3035", "--metric", "planar"}), "");
}

}  // namespace
}  // namespace thiessen::cli
