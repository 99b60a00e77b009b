#include "files/normals/raster_study.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "files/normals/given_study.h"

namespace thiessen {
namespace {

/// A grid in text, whose lower left corner is at the origin.
std::string grid(int columns, int rows, const std::string& values,
                 const std::string& corner = "0") {
  return "ncols " + std::to_string(columns) + "\nnrows " + std::to_string(rows) + "\nxllcorner " +
         corner + "\nyllcorner " + corner + "\ncellsize 1\nNODATA_value -5\n" + values;
}

/// Bands of another raster, called source.asc, with a geotransform, and what else is said of each.
std::string bands_of(int columns, int rows, const std::string& transform, int count,
                     const std::string& type = "Float32", const std::string& said = {}) {
  std::string text = "<VRTDataset rasterXSize=\"" + std::to_string(columns) + "\" rasterYSize=\"" +
                     std::to_string(rows) + "\"><GeoTransform>" + transform + "</GeoTransform>";
  for (int band = 1; band <= count; ++band) {
    text += "<VRTRasterBand dataType=\"" + type + "\" band=\"" + std::to_string(band) + "\">" +
            said +
            "<SimpleSource><SourceFilename relativeToVRT=\"1\">source.asc</SourceFilename>"
            "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand>";
  }
  return text + "</VRTDataset>";
}

/// The gauges stand in pixels of 2.5 and 8, and the mean of all is 4.
const std::string slope = "1 2 2.5 2.5 5 5 8 6\n";

std::shared_ptr<const NormalField> normals_of(GivenStudy& given, const std::string& name,
                                              const std::string& text) {
  if (!given.study) given.read();
  return normals_of_raster(given.folder.write(name, text), *given.study, *given.files,
                           given.warnings);
}

std::vector<std::string> faults_of(const std::string& name, const std::string& text,
                                   const std::string& source = {}) {
  GivenStudy given;
  given.folder.write("source.asc", source);
  std::vector<std::string> faults = complaints_of([&] { normals_of(given, name, text); });
  for (std::string& fault : faults) {
    const std::size_t folder = fault.find(given.folder.path());
    if (folder != std::string::npos) fault.erase(folder, given.folder.path().size() + 1);
  }
  return faults;
}

void expect_slope(const NormalField& normals) {
  EXPECT_EQ(normals.at_gauge(StationIndex{0}, 0), 2.5);
  EXPECT_EQ(normals.at_gauge(StationIndex{1}, 0), 8);
  EXPECT_DOUBLE_EQ(normals.in(0).whole(0).mean, 4);
  EXPECT_EQ(normals.in(0).whole(0).covered, 1);
}

TEST(NormalsOfRaster, are_those_of_pixels_at_gauges_and_over_basins) {
  GivenStudy given;
  const auto normals = normals_of(given, "n.asc", grid(8, 4, slope + slope + slope + slope));
  EXPECT_EQ(normals->months(), 1u);
  expect_slope(*normals);
  EXPECT_TRUE(given.warnings.messages().empty());
}

// Rows that run upwards; and a raster that lies on its side, whose rows are columns of the plane.
TEST(NormalsOfRaster, lie_however_the_geotransform_says) {
  GivenStudy given;
  given.folder.write("source.asc", grid(8, 4, slope + slope + slope + slope));
  expect_slope(*normals_of(given, "up.vrt", bands_of(8, 4, "0, 1, 0, 0, 0, 1", 1)));
  given.folder.write("source.asc", grid(4, 8,
                                        "1 1 1 1\n2 2 2 2\n2.5 2.5 2.5 2.5\n2.5 2.5 2.5 2.5\n"
                                        "5 5 5 5\n5 5 5 5\n8 8 8 8\n6 6 6 6\n"));
  expect_slope(*normals_of(given, "side.vrt", bands_of(4, 8, "0, 0, 1, 0, 1, 0", 1)));
}

TEST(NormalsOfRaster, may_be_stored_as_whole_numbers_with_a_scale) {
  GivenStudy given;
  given.folder.write("source.asc", grid(8, 4,
                                        "10 20 25 25 50 50 80 60\n10 20 25 25 50 50 80 60\n"
                                        "10 20 25 25 50 50 80 60\n10 20 25 25 50 50 80 60\n"));
  const std::string said = "<Offset>0</Offset><Scale>0.1</Scale>";
  const auto normals =
      normals_of(given, "n.vrt", bands_of(8, 4, "0, 1, 0, 4, 0, -1", 1, "Int16", said));
  EXPECT_DOUBLE_EQ(normals->at_gauge(StationIndex{0}, 0), 2.5);
  EXPECT_DOUBLE_EQ(normals->in(0).whole(0).mean, 4);
}

TEST(NormalsOfRaster, of_twelve_bands_are_those_of_months) {
  GivenStudy given;
  given.folder.write("source.asc", grid(8, 4, slope + slope + slope + slope));
  const auto normals = normals_of(given, "n.vrt", bands_of(8, 4, "0, 1, 0, 4, 0, -1", 12));
  EXPECT_EQ(normals->months(), 12u);
  EXPECT_DOUBLE_EQ(normals->in(0).whole(11).mean, 4);
  for (const int bands : {2, 3, 11, 13}) {
    EXPECT_EQ(faults_of("n.vrt", bands_of(8, 4, "0, 1, 0, 4, 0, -1", bands),
                        grid(8, 4, slope + slope + slope + slope)),
              std::vector<std::string>{"n.vrt: has " + std::to_string(bands) +
                                       " bands, and normals have one, or twelve for the calendar "
                                       "months | gdal_translate -b N makes a raster of one"});
  }
}

TEST(NormalsOfRaster, that_cover_a_part_of_a_basin_are_told) {
  GivenStudy given{.stations = "id,x,y\na,2,1\nb,6,1\n"};
  const auto normals = normals_of(given, "n.asc", grid(8, 2, slope + slope));
  EXPECT_DOUBLE_EQ(normals->in(0).whole(0).mean, 4);
  EXPECT_DOUBLE_EQ(normals->in(0).whole(0).covered, 0.5);
  EXPECT_EQ(sentences_of(given.warnings).size(), 1u);
  EXPECT_TRUE(
      contains(sentences_of(given.warnings).at(0), "has no normals on 50.0 % of basin 'B'"));
}

TEST(NormalsOfRaster, of_another_place_are_an_error) {
  EXPECT_EQ(
      faults_of("n.asc", grid(2, 2, "5 5\n5 5\n", "100")),
      std::vector<std::string>{
          "n.asc: none of the stations stands in it: its coordinates are x from 100 to 102 and "
          "y from 100 to 102, and theirs are x from 2 to 6 and y from 2 to 2 | the raster is "
          "of another place, or in another CRS than it says, which gdal_translate -a_srs puts "
          "right"});
  EXPECT_EQ(
      faults_of("n.asc", grid(4, 4, "5 5 5 5\n5 5 5 5\n5 5 5 5\n5 5 5 5\n")),
      std::vector<std::string>{"n.asc: station 'b' lies outside of the raster | 'stations_where' "
                               "leaves stations out of the network"});
}

TEST(NormalsOfRaster, that_are_none_are_an_error) {
  const std::string bad = "1 2 2.5 2.5 5 5 -9999 -9999\n";
  EXPECT_EQ(
      faults_of("n.asc", grid(8, 4, slope + bad + bad + slope)),
      std::vector<std::string>{"n.asc: station 'b' has the normal -9999, and normals are above "
                               "0 | 'stations_where' leaves stations out of the network"});
  EXPECT_EQ(faults_of("n.asc", grid(8, 4, slope + slope + slope + bad)),
            std::vector<std::string>{
                "n.asc: has normals that are not above 0 on 6.2 % of basin 'B' | gdal_translate "
                "-a_nodata takes such a value for none"});
  EXPECT_EQ(faults_of("n.asc",
                      grid(8, 4, slope + "1 2 -5 2.5 5 5 8 6\n" + "1 2 -5 2.5 5 5 8 6\n" + slope)),
            std::vector<std::string>{"n.asc: station 'a' has no normal | 'stations_where' leaves "
                                     "stations out of the network"});
}

TEST(NormalsOfRaster, are_no_pictures) {
  const std::string text =
      faults_of("n.vrt",
                bands_of(8, 4, "0, 1, 0, 4, 0, -1", 1, "Byte",
                         "<ColorInterp>Palette</ColorInterp><ColorTable><Entry "
                         "c1=\"0\" c2=\"0\" c3=\"0\"/></ColorTable>"),
                grid(8, 4, slope + slope + slope + slope))
          .at(0);
  EXPECT_EQ(text,
            "n.vrt: is a picture: the numbers of its band 1 stand for colours of a palette | where "
            "they are values all the same, gdal_translate -b 1 -colorinterp gray makes a raster of "
            "them");
}

TEST(NormalsOfRaster, of_a_file_that_is_cut_off_are_an_error) {
  const std::string text = faults_of("n.asc", grid(8, 4, slope + slope)).at(0);
  EXPECT_TRUE(contains(text, "n.asc: is cut off or no whole grid: row 3 of its 4 ")) << text;
}

// Of longitudes from 0 to 360 and a study west of Greenwich.
TEST(NormalsOfRaster, may_count_longitudes_from_0_to_360) {
  GivenStudy given{.stations = "id,lon,lat\na,-108,2\nb,-104,2\n",
                   .basins = "id,WKT\nB,\"POLYGON((-110 0,-102 0,-102 4,-110 4,-110 0))\"\n",
                   .metric = Metric::geodesic,
                   .crs = "EPSG:4326"};
  given.folder.write("source.asc", grid(8, 4, slope + slope + slope + slope));
  const auto normals = normals_of(given, "n.vrt", bands_of(8, 4, "250, 1, 0, 4, 0, -1", 1));
  EXPECT_EQ(normals->at_gauge(StationIndex{1}, 0), 8);
  EXPECT_NEAR(normals->in(0).whole(0).mean, 4, 1e-9);
  EXPECT_EQ(normals->in(0).whole(0).covered, 1);
}

}  // namespace
}  // namespace thiessen
