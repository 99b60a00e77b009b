#include "files/places/station_fields.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_field = 1 << 20;

/// The fields of a file as it is called; a CSV's are those of its first line.
StationFields fields_of(const std::string& text, StationsRequest request = {},
                        const std::string& name = "s.csv") {
  const TemporaryFolder folder;
  request.source.file = folder.write(name, text);
  Warnings warnings;
  const Features features(request.source, longest_field, warnings);
  return find_station_fields(features, request);
}

std::string fault_of(const std::string& text, const StationsRequest& request = {}) {
  const std::string complaint = complaint_of([&] { fields_of(text, request); });
  return complaint.substr(complaint.find("s.csv"));
}

/// The places of the id, x and y; the id is -1 where there is none.
struct Places {
  int id;
  int x;
  int y;
  friend bool operator==(const Places&, const Places&) = default;
};

Places places_of(const std::string& header, const StationsRequest& request = {}) {
  const StationFields fields = fields_of(header + "\n1,2,3\n", request);
  EXPECT_FALSE(fields.by_geometry);
  return {fields.id ? static_cast<int>(*fields.id) : -1, static_cast<int>(fields.x),
          static_cast<int>(fields.y)};
}

TEST(StationFields, are_found_by_usual_names_in_any_language_and_case) {
  EXPECT_EQ(places_of("id,lon,lat"), (Places{0, 1, 2}));
  EXPECT_EQ(places_of("LAT,Station,LONG"), (Places{1, 2, 0}));
  EXPECT_EQ(places_of("Northing,easting,gauge"), (Places{2, 1, 0}));
  EXPECT_EQ(places_of("geoBreite,geoLaenge,Stations_id"), (Places{2, 1, 0}));
  EXPECT_EQ(places_of("観測所,経度,緯度"), (Places{0, 1, 2}));
}

// A table may have the same place in degrees and in a plane; English names of degrees come first.
TEST(StationFields, of_several_the_first_by_name_counts_and_not_by_place) {
  const StationFields fields = fields_of("x,y,lat,lon,name,id\n1,2,3,4,5,6\n");
  EXPECT_EQ(fields.x, 3U);
  EXPECT_EQ(fields.y, 2U);
  EXPECT_EQ(fields.id, 5U);
}

TEST(StationFields, without_a_usual_name_the_id_is_the_first_that_is_no_position_and_no_rainfall) {
  EXPECT_EQ(places_of("x,what,y"), (Places{1, 0, 2}));
  EXPECT_EQ(places_of("x,y,rain"), (Places{-1, 0, 1}));
  EXPECT_EQ(places_of("Precipitation,x,y").id, -1);
  EXPECT_EQ(fields_of("rain,x,elev,y\n1,2,3,4\n").id, 2U);
}

TEST(StationFields, are_those_that_the_request_names) {
  StationsRequest request;
  request.id = "B";
  request.x = "u";
  request.y = "V";
  request.label = "name";
  const StationFields fields = fields_of("id,x,y,b,name,U,v\n1,2,3,4,5,6,7\n", request);
  EXPECT_EQ(fields.id, 3U);
  EXPECT_EQ(fields.x, 5U);
  EXPECT_EQ(fields.y, 6U);
  EXPECT_EQ(fields.label, 4U);
  EXPECT_FALSE(fields_of("id,x,y\n1,2,3\n").label) << "no label unless it is asked for";
}

TEST(StationFields, that_are_named_have_to_be_there) {
  for (const auto& [member, setting] : {std::pair{&StationsRequest::id, "id"},
                                        {&StationsRequest::x, "x"},
                                        {&StationsRequest::y, "y"},
                                        {&StationsRequest::label, "label"}}) {
    StationsRequest request;
    request.*member = "w";
    EXPECT_EQ(fault_of("id,x,y\n1,2,3\n", request),
              "s.csv:1: '" + std::string(setting) + "': no field 'w'; found 'id', 'x', 'y'");
  }
}

TEST(StationFields, without_coordinates_say_which_were_wanted_and_found) {
  EXPECT_EQ(fault_of("id,a\n1,2\n"),
            "s.csv:1: no field of coordinates: wanted lon, long, longitude, x, easting, and lat, "
            "latitude, y, northing; found 'id', 'a' | name them with 'x' and 'y'");
  EXPECT_EQ(
      fault_of("id,X\n1,2\n"),
      "s.csv:1: no field of coordinates: wanted lat, latitude, y, northing; found 'id', 'X' | "
      "name it with 'y'");
  EXPECT_EQ(fault_of("\n\nid,y\n1,2\n"),
            "s.csv:3: no field of coordinates: wanted lon, long, longitude, x, easting; found "
            "'id', 'y' | name it with 'x'");
}

TEST(StationFields, are_degrees_where_both_names_say_so) {
  EXPECT_TRUE(fields_of("id,lon,lat\n1,2,3\n").are_degrees);
  EXPECT_TRUE(fields_of("id,Longitude_deg,latitude (y)\n1,2,3\n").are_degrees);
  EXPECT_FALSE(fields_of("id,x,y\n1,2,3\n").are_degrees);
  EXPECT_FALSE(fields_of("id,x,lat\n1,2,3\n").are_degrees);
  StationsRequest request;
  request.x = "lat";
  request.y = "lon";
  EXPECT_TRUE(fields_of("id,lon,lat\n1,2,3\n", request).are_degrees) << "whichever is which";
}

TEST(StationFields, are_geometries_where_there_are_any) {
  EXPECT_TRUE(fields_of("x,WKT,y\n1,POINT (2 3),4\n").by_geometry);
  const StationFields geometry = fields_of("x,WKT\n1,POINT (2 3)\n");
  EXPECT_TRUE(geometry.by_geometry);
  EXPECT_EQ(geometry.id, 0U) << "x is no coordinate then";
  EXPECT_FALSE(fields_of("WKT\nPOINT (2 3)\n").id) << "a geometry is no id";
  const std::string points = R"({"type":"Feature","properties":{"lon":1,"lat":2},"geometry":)"
                             R"({"type":"Point","coordinates":[3,4]}})";
  EXPECT_TRUE(fields_of(points, {}, "s.geojson").by_geometry);
  StationsRequest request;
  request.x = "lon";
  EXPECT_FALSE(fields_of(points, request, "s.geojson").by_geometry) << "the user wants columns";
}

// A word for rocks, or a geometry: where there are coordinates they count.
TEST(StationFields, a_column_that_may_hold_geometries_counts_only_without_coordinates) {
  EXPECT_FALSE(fields_of("id,x,y,geom\na,1,2,igneous\n").by_geometry);
  EXPECT_TRUE(fields_of("id,x,geom\na,1,POINT (1 2)\n").by_geometry);
}

}  // namespace
}  // namespace thiessen
