#include "files/places/station_positions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_field = 1 << 20;

/// The positions of a file of stations whose first field is their id, as they were read.
struct Read {
  explicit Read(const std::string& text, StationsRequest request = {},
                const std::string& name = "s.csv") {
    const TemporaryFolder folder;
    request.source.file = folder.write(name, text);
    Warnings warnings;
    Features features(request.source, longest_field, warnings);
    const StationFields fields = find_station_fields(features, request);
    Complaints complaints;
    StationPositions positions(features, fields, request, complaints);
    while (features.next(complaints)) {
      Station station;
      station.id = std::string(features.row().fields[0]);
      placings.push_back(positions.read(station));
      if (placings.back() == Placing::good) points.push_back(station.position);
    }
    first_angle = positions.first_angle();
    has_heights = positions.has_heights();
    if (complaints.empty()) return;
    for (std::string sentence : complaints_of([&] { complaints.throw_if_any(); }))
      faults.push_back(sentence.substr(sentence.find(name) + name.size()));
  }

  std::vector<Placing> placings;
  std::vector<Point> points;  ///< of those that are good
  std::vector<std::string> faults;
  std::string first_angle;
  bool has_heights = false;
};

using Placings = std::vector<Placing>;
using Points = std::vector<Point>;
using Texts = std::vector<std::string>;

StationsRequest passing_over() {
  StationsRequest request;
  request.skip_unplaced = true;
  return request;
}

TEST(StationPositions, are_numbers_of_two_columns_with_every_digit) {
  const Read read("id,y,x\na,0.1, 12345678.123456789 \nb,-1e-3,7\n");
  EXPECT_EQ(read.placings, (Placings{Placing::good, Placing::good}));
  EXPECT_EQ(read.points, (Points{{12345678.123456789, 0.1}, {7, -0.001}}));
  EXPECT_EQ(read.first_angle, "");
  EXPECT_FALSE(read.has_heights);
}

TEST(StationPositions, have_no_negative_zero) {
  const Read read("id,x,y\na,-0,-0.0\n");
  EXPECT_FALSE(std::signbit(read.points.at(0).x));
  EXPECT_FALSE(std::signbit(read.points[0].y));
  const Read geometry("id,wkt\na,POINT (-0 -0)\n");
  EXPECT_FALSE(std::signbit(geometry.points.at(0).x));
}

TEST(StationPositions, that_are_no_numbers_are_named_each_by_its_column) {
  const Read read("id,x,y\na,nope,0x10\nb,1e999,2\nc,,2\nd,1,\"1,5\"\ne,3.5,4\n");
  EXPECT_EQ(read.placings,
            (Placings{Placing::bad, Placing::bad, Placing::bad, Placing::bad, Placing::good}));
  EXPECT_EQ(read.points, Points({{3.5, 4}}));
  ASSERT_EQ(read.faults.size(), 5U);
  EXPECT_EQ(read.faults[0], ":2: 'x' of station 'a' is no number: 'nope'");
  EXPECT_EQ(read.faults[1], ":2: 'y' of station 'a' is no number: '0x10'");
  EXPECT_EQ(read.faults[2], ":3: 'x' of station 'b' is outside the range of numbers: '1e999'");
  EXPECT_EQ(read.faults[3],
            ":4: 'x' of station 'c' is empty | 'stations_where' leaves stations out");
  EXPECT_TRUE(read.faults[4].starts_with(":5: 'y' of station 'd' is no number")) << read.faults[4];
  EXPECT_TRUE(read.faults[4].ends_with("| 'stations_decimal_comma' reads 1,5 as 1.5"))
      << read.faults[4];
}

TEST(StationPositions, of_a_station_without_coordinates_are_bad_or_nowhere_as_it_is_wanted) {
  const std::string text = "id,x,y\na,,\nb, ,\nc,1,2\n";
  const Read bad(text);
  EXPECT_EQ(bad.placings, (Placings{Placing::bad, Placing::bad, Placing::good}));
  EXPECT_EQ(bad.faults.at(0),
            ":2: station 'a' has no coordinates | 'skip_unplaced' passes over stations without "
            "coordinates");
  const Read skipped(text, passing_over());
  EXPECT_EQ(skipped.placings, (Placings{Placing::nowhere, Placing::nowhere, Placing::good}));
  EXPECT_TRUE(skipped.faults.empty());
  EXPECT_EQ(Read("id,x,y\na,,2\n", passing_over()).placings, Placings{Placing::bad})
      << "half a coordinate is a fault";
}

TEST(StationPositions, that_are_texts_or_numbers_for_no_reading_are_none) {
  const std::string text = "id,x,y\na,NA,n/a\nb,null, - \nc,-999,-999.0\nd,-9999,-9999\ne,,NaN\n";
  const Read bad(text);
  EXPECT_EQ(bad.placings, Placings(5, Placing::bad));
  ASSERT_EQ(bad.faults.size(), 5U);
  EXPECT_EQ(bad.faults[0],
            ":2: station 'a' has no coordinates: 'NA' and 'n/a' mean none | 'skip_unplaced' passes "
            "over stations without coordinates");
  EXPECT_EQ(bad.faults[2], ":4: station 'c' has no coordinates: '-999' and '-999.0' mean none");
  const Read skipped(text, passing_over());
  EXPECT_EQ(skipped.placings, Placings(5, Placing::nowhere));
  EXPECT_TRUE(skipped.faults.empty());
}

// A plane may have its origin where it likes; -999 beside another number is a coordinate there.
TEST(StationPositions, of_a_plane_may_be_numbers_that_mean_no_reading) {
  EXPECT_EQ(Read("id,x,y\na,-999,5\nb,-99.9,-99.9\nc,-999,-9999\n", passing_over()).points,
            (Points{{-999, 5}, {-99.9, -99.9}, {-999, -9999}}));
}

TEST(StationPositions, in_degrees_are_none_where_no_degree_can_be_such_a_number) {
  const std::string text = "id,lon,lat\na,-999,-9999\nb,-99.9,-99.9\nc,-99.9,40\nd,-999,40\n";
  const Read skipped(text, passing_over());
  EXPECT_EQ(skipped.placings,
            (Placings{Placing::nowhere, Placing::nowhere, Placing::good, Placing::bad}));
  EXPECT_EQ(skipped.points, Points({{-99.9, 40}}));
  EXPECT_EQ(skipped.faults, (Texts{":5: 'lon' of station 'd' is missing: '-999' | "
                                   "'stations_where' leaves stations out"}));
}

TEST(StationPositions, of_points_at_a_number_that_means_no_reading_are_none) {
  const std::string text = "id,wkt\na,POINT (-999 -999)\nb,POINT (-9999 -9999)\nc,POINT (-999 3)\n";
  EXPECT_EQ(Read(text, passing_over()).placings,
            (Placings{Placing::nowhere, Placing::nowhere, Placing::good}));
  EXPECT_EQ(Read(text).faults.at(0),
            ":2: station 'a' has no coordinates: '-999' and '-999' mean none | 'skip_unplaced' "
            "passes over stations without coordinates");
}

TEST(StationPositions, are_read_from_degrees_minutes_and_seconds) {
  const Read read("id,lon,lat\na,1.5,47 15\nb,5d30'W,\"47°15'0\"\"S\"\nc,10:30,0:30:0\n");
  EXPECT_EQ(read.points, (Points{{1.5, 47.25}, {-5.5, -47.25}, {10.5, 0.5}}));
  EXPECT_EQ(read.first_angle, "'47 15' for 47.25") << "the first is told";
}

// 12:30 in a column that nothing calls degrees may be a time.
TEST(StationPositions, in_other_columns_are_angles_only_where_a_letter_says_so) {
  EXPECT_EQ(Read("id,x,y\na,10:30E,47 15N\n").points, Points({{10.5, 47.25}}));
  const Read read("id,x,y\na,10:30,47:15\n");
  EXPECT_EQ(read.faults, (Texts{":2: 'x' of station 'a' is no number: '10:30'",
                                ":2: 'y' of station 'a' is no number: '47:15'"}));
}

// A hint is given once.
TEST(StationPositions, whose_letter_is_of_the_other_coordinate_are_refused) {
  const Read read("id,lon,lat\na,10:30N,47:15E\n");
  EXPECT_EQ(read.faults,
            (Texts{":2: 'lon' of station 'a' is a latitude: '10:30N' | 'x' and 'y' name the fields",
                   ":2: 'lat' of station 'a' is a longitude: '47:15E'"}));
}

TEST(StationPositions, of_geometries_are_those_of_one_point) {
  const Read read(
      "id,wkt\na,POINT (1.5 2)\nb,MULTIPOINT (3 4)\nc,POINT Z (5 6 7)\nd,\"MULTIPOINT (1 2,3 "
      "4)\"\ne,\"LINESTRING (0 0,1 1)\"\nf,\"POLYGON ((0 0,1 0,1 1,0 0))\"\ng,POINT (1\n");
  EXPECT_EQ(read.points, (Points{{1.5, 2}, {3, 4}, {5, 6}}));
  EXPECT_TRUE(read.has_heights);
  ASSERT_EQ(read.faults.size(), 4U);
  EXPECT_EQ(read.faults[0],
            ":5: station 'd' has more than one point | 'stations_where' leaves stations out");
  EXPECT_EQ(read.faults[1], ":6: station 'e' is a LineString, and not a point");
  EXPECT_EQ(read.faults[2],
            ":7: station 'f' is a Polygon, and not a point | are 'stations' and 'basins' in each "
            "other's place?");
  EXPECT_TRUE(read.faults[3].starts_with(":8: not a geometry in WKT")) << read.faults[3];
}

TEST(StationPositions, of_a_station_without_a_geometry_are_bad_or_nowhere_as_it_is_wanted) {
  const std::string text = "id,wkt\na,\nb,POINT EMPTY\nc,MULTIPOINT EMPTY\n";
  const Read bad(text);
  EXPECT_EQ(bad.placings, (Placings{Placing::bad, Placing::bad, Placing::bad}));
  EXPECT_EQ(bad.faults.at(0),
            ":2: station 'a' has no geometry | 'skip_unplaced' passes over stations without "
            "coordinates");
  EXPECT_TRUE(bad.faults.at(1).starts_with(":3: station 'b' has an empty geometry"));
  const Read skipped(text, passing_over());
  EXPECT_EQ(skipped.placings, (Placings{Placing::nowhere, Placing::nowhere, Placing::bad}));
}

TEST(StationPositions, that_are_not_finite_are_refused) {
  const Read read("id,wkt\na,POINT (1 nan)\nb,POINT (1e400 2)\n");
  EXPECT_TRUE(read.points.empty());
  EXPECT_EQ(read.faults.size(), 2U);
}

}  // namespace
}  // namespace thiessen
