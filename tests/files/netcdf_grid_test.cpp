#include "files/netcdf_grid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "files/netcdf_reading.h"

namespace thiessen {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

RasterOutput output_in(const char* crs) {
  RasterOutput output;
  output.grid = {{10, 52}, 0.5, 3, 2};
  output.crs = Crs::from_text(crs, setting("crs"));
  output.made_by.software = "thiessen 9";
  output.made_by.unit = "mm";
  output.path = "grid.nc";
  return output;
}

using Numbers = std::vector<double>;

TEST(NetcdfGrid, holds_steps_with_times_and_places) {
  const TemporaryFolder folder;
  const RasterOutput output = output_in("EPSG:4326");
  NetcdfGrid grid(folder.path("a.nc"), output, {{{86400, 90000}, {90000, 93600}}, true});
  grid.add(std::array{1.0F, 2.0F, 3.0F, 4.0F, 5.0F, none});
  grid.add(std::array{0.5F, none, none, none, none, none});
  grid.close();
  const NetcdfReading found(folder.path("a.nc"));
  EXPECT_EQ(found.dimensions("rainfall"), "time lat lon");
  EXPECT_EQ(found.dimensions("time_bnds"), "time nv");
  EXPECT_EQ(found.numbers("time", 2), (Numbers{86400, 90000}));
  EXPECT_EQ(found.numbers("time_bnds", 4), (Numbers{86400, 90000, 90000, 93600}));
  EXPECT_EQ(found.numbers("lat", 2), (Numbers{51.75, 51.25}));
  EXPECT_EQ(found.numbers("lon", 3), (Numbers{10.25, 10.75, 11.25}));
  const Numbers rainfall = found.numbers("rainfall", 12);
  EXPECT_EQ(Numbers(rainfall.begin(), rainfall.begin() + 5), (Numbers{1, 2, 3, 4, 5}));
  EXPECT_TRUE(std::isnan(rainfall[5]));
  EXPECT_EQ(rainfall[6], 0.5);
  EXPECT_EQ(found.text("time", "units"), "seconds since 1970-01-01 00:00:00 +00:00");
  EXPECT_EQ(found.text("time", "bounds"), "time_bnds");
  EXPECT_EQ(found.text("lat", "units"), "degrees_north");
  EXPECT_EQ(found.text("rainfall", "units"), "mm");
  EXPECT_EQ(found.text("rainfall", "cell_methods"), "time: sum");
  EXPECT_EQ(found.text("rainfall", "grid_mapping"), "crs");
  EXPECT_EQ(found.text("crs", "grid_mapping_name"), "latitude_longitude");
  EXPECT_EQ(found.text("", "Conventions"), "CF-1.8");
  EXPECT_EQ(found.text("", "source"), "thiessen 9");
}

TEST(NetcdfGrid, in_a_projection_or_a_plane_of_its_own_has_y_and_x) {
  const TemporaryFolder folder;
  RasterOutput output = output_in("EPSG:32633");
  NetcdfGrid(folder.path("a.nc"), output, {{{0, 1}}, false}).close();
  const NetcdfReading projected(folder.path("a.nc"));
  EXPECT_EQ(projected.dimensions("rainfall"), "time y x");
  EXPECT_EQ(projected.text("x", "standard_name"), "projection_x_coordinate");
  EXPECT_EQ(projected.text("x", "units"), "m");
  EXPECT_EQ(projected.text("time", "units"), "seconds since 1970-01-01 00:00:00");
  output.crs.reset();
  NetcdfGrid(folder.path("b.nc"), output, {{{0, 1}}, false}).close();
  const NetcdfReading plane(folder.path("b.nc"));
  EXPECT_EQ(plane.text("rainfall", "grid_mapping"), "none");
  EXPECT_EQ(plane.text("y", "standard_name"), "none");
}

TEST(NetcdfGrid, of_a_rate_is_a_mean_over_time_and_of_a_moment_neither) {
  const TemporaryFolder folder;
  RasterOutput output = output_in("EPSG:32633");
  for (const char* rate : {"mm/h", "mm per day", "mm d-1"}) {
    output.made_by.unit = rate;
    const std::string path = folder.path(std::string(1, rate[3]) + ".nc");
    NetcdfGrid(path, output, {{{0, 1}}, false}).close();
    EXPECT_EQ(NetcdfReading(path).text("rainfall", "cell_methods"), "time: mean") << rate;
  }
  NetcdfGrid(folder.path("moment.nc"), output, {{{5, 5}}, false}).close();
  const NetcdfReading moment(folder.path("moment.nc"));
  EXPECT_EQ(moment.text("rainfall", "cell_methods"), "none");
  EXPECT_EQ(moment.text("time", "bounds"), "none");
  EXPECT_EQ(moment.numbers("time", 1), (Numbers{5}));
}

TEST(NetcdfGrid, is_not_compressed_by_zstd) {
  RasterOutput output = output_in("EPSG:4326");
  output.compression = Compression::zstd;
  EXPECT_THROW(NetcdfGrid("unused.nc", output, {}), Error);
}

}  // namespace
}  // namespace thiessen
