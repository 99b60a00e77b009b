#include "text/points_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

template <int Dimension>
std::vector<PositionIn<Dimension>> read(const std::string& text, Warnings& warnings) {
  const TemporaryFolder folder;
  return read_points<Dimension>(folder.write("p.csv", text), warnings);
}
template <int Dimension>
std::vector<PositionIn<Dimension>> read(const std::string& text) {
  Warnings warnings;
  return read<Dimension>(text, warnings);
}

/// Without the folder's name.
std::vector<std::string> complaints(const std::string& text) {
  auto sentences = complaints_of([&] { read<2>(text); });
  for (std::string& sentence : sentences) {
    const std::size_t file = sentence.find("p.csv");
    const std::size_t begin = sentence.rfind(' ', file);
    sentence.erase(begin == std::string::npos ? 0 : begin + 1,
                   file - (begin == std::string::npos ? 0 : begin + 1));
  }
  return sentences;
}

TEST(PointsFile, is_read_with_a_header_and_without) {
  const std::vector<Point> points{{1, 2}, {3.5, -4e2}};
  EXPECT_EQ(read<2>("x,y\n1,2\n3.5,-4e2\n"), points);
  EXPECT_EQ(read<2>("1,2\n3.5,-4e2"), points);
  EXPECT_EQ(read<2>("name,Northing,EASTING\na,2,1\n\"b,c\", -400 ,3.5\n"), points);
  EXPECT_EQ(read<2>("5,5\n"), (std::vector<Point>{{5, 5}}));
  EXPECT_EQ(read<3>("x,y,z\n1,2,3\n"), (std::vector<SpacePoint>{{1, 2, 3}}));
  EXPECT_EQ(read<3>("7,7,7\n8,8,8\n"), (std::vector<SpacePoint>{{7, 7, 7}, {8, 8, 8}}));
}

TEST(PointsFile, has_no_negative_zero) {
  const auto points = read<2>("x,y\n-0,-0.0\n");
  EXPECT_FALSE(std::signbit(points[0].x));
  EXPECT_FALSE(std::signbit(points[0].y));
}

TEST(PointsFile, in_a_plane_passes_over_heights_and_says_so) {
  Warnings warnings;
  EXPECT_EQ(read<2>("x,y,z\n1,2,3\n", warnings), (std::vector<Point>{{1, 2}}));
  ASSERT_EQ(warnings.messages().size(), 1u);
  EXPECT_EQ(warnings.messages()[0].text, "heights (z) are passed over");
}

TEST(PointsFile, reports_every_bad_row) {
  const std::string range =
      " is outside the supported range: 0, or 1.8e-43 to 3.2e60 in magnitude: ";
  EXPECT_EQ(complaints("x,y\n1,nan\n1\n2,1e999\n3,\n4,4\n1e-50,inf\n"),
            (std::vector<std::string>{
                "p.csv:2: 'y' is no number: 'nan'", "p.csv:3: row has 1 field, the header has 2",
                "p.csv:4: 'y'" + range + "'1e999'", "p.csv:5: 'y' is empty",
                "p.csv:7: 'x'" + range + "'1e-50'", "p.csv:7: 'y' is no number: 'inf'"}));
  EXPECT_EQ(complaints("1,2\n3,abc\n"), std::vector<std::string>{"p.csv:2: y is no number: 'abc'"});
  EXPECT_EQ(complaints("1,abc\n"), std::vector<std::string>{"p.csv:1: y is no number: 'abc'"});
}

TEST(PointsFile, says_what_columns_it_wants) {
  EXPECT_EQ(complaints("a,b\n1,2\n")[0],
            "p.csv:1: no field of coordinates: wanted x, lon, long, longitude, easting, and y, "
            "lat, latitude, northing; found 'a', 'b' | fields are parted by commas");
  EXPECT_EQ(complaints("1,2,3\n")[0],
            "p.csv:1: without a header, rows are 2 coordinates, and this has 3 fields | a header "
            "names the fields: x, y");
  EXPECT_EQ(complaints("1\n")[0],
            "p.csv:1: without a header, rows are 2 coordinates, and this has 1 field | fields are "
            "parted by commas");
  EXPECT_EQ(complaints("x,y\n")[0], "no points in p.csv");
  EXPECT_EQ(complaints("")[0], "p.csv: is empty");
}

}  // namespace
}  // namespace thiessen
