#include "gdal/crs/spheres.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gdal/crs/crs.h"
#include "gdal/crs/crs_definition.h"
#include "gdal/crs/transformation.h"

namespace thiessen {
namespace {

/// The definition of a sphere as tools write it, with what follows its ellipsoid.
std::string geogcs(const std::string& ellipsoid) {
  return "GEOGCS[\"sphere\",DATUM[\"D_Sphere\"," + ellipsoid +
         "],PRIMEM[\"Greenwich\",0],UNIT[\"Degree\",0.0174532925199433]]";
}

std::string lambert(const std::string& ellipsoid) {
  return "PROJCS[\"lcc\"," + geogcs(ellipsoid) +
         ",PROJECTION[\"Lambert_Conformal_Conic_2SP\"],PARAMETER[\"standard_parallel_1\",30],"
         "PARAMETER[\"standard_parallel_2\",60],PARAMETER[\"latitude_of_origin\",40],"
         "PARAMETER[\"central_meridian\",10],PARAMETER[\"false_easting\",0],"
         "PARAMETER[\"false_northing\",0],UNIT[\"Meter\",1]]";
}

const char* const zeros = "SPHEROID[\"s\",6370000,0],TOWGS84[0,0,0]";
const char* const seven_zeros = "SPHEROID[\"s\",6370000,0],TOWGS84[0,0,0,0,0,0,0]";
const char* const bare = "SPHEROID[\"s\",6370000,0]";

// Law 1: longitudes and latitudes on a sphere are those of WGS 84, to the bit.
TEST(Spheres, law_1_degrees_stay_as_they_are) {
  for (const std::string& text :
       {std::string("+proj=longlat +R=6370000"),
        std::string("+proj=longlat +R=6370000 +towgs84=0,0,0"),
        std::string("+proj=longlat +a=6371229 +b=6371229 +towgs84=0,0,0,0,0,0,0"),
        std::string("+proj=longlat +ellps=sphere"), std::string("EPSG:4035"),
        std::string("EPSG:4047"), std::string("EPSG:4055"), std::string("ESRI:104199"),
        std::string("ESRI:37008"), geogcs(bare), geogcs(zeros), geogcs(seven_zeros),
        geogcs("SPHEROID[\"s\",6371229,0],TOWGS84[10,20,30]"),
        std::string("GEOGCS[\"WRF\",DATUM[\"WGS_1984\",SPHEROID[\"s\",6370000,0]],"
                    "PRIMEM[\"Greenwich\",0],UNIT[\"Degree\",0.0174532925199433]]")}) {
    const Crs crs = Crs::from_text(text, "CRS");
    const Transformation transformation(crs, Crs::wgs84());
    std::vector<Point> points = {{10.25, 46.5}, {-170, -33}};
    EXPECT_EQ(transformation.apply(points), (std::vector<bool>{true, true})) << text;
    EXPECT_NEAR(points[0].x, 10.25, 1e-13) << text;
    EXPECT_NEAR(points[0].y, 46.5, 1e-13) << text;
    EXPECT_NEAR(points[1].x, -170, 1e-13) << text;
    EXPECT_NEAR(points[1].y, -33, 1e-13) << text;
    ASSERT_FALSE(transformation.identity()) << text;
    EXPECT_EQ(transformation.choice()->sphere, crs.name()) << text;
  }
}

// Law 2: a shift beside a sphere changes nothing.
TEST(Spheres, law_2_a_shift_says_nothing) {
  const Crs plain = Crs::from_text(lambert(bare), "CRS");
  for (const char* ellipsoid : {zeros, seven_zeros}) {
    const Crs crs = Crs::from_text(lambert(ellipsoid), "CRS");
    EXPECT_TRUE(crs.same_as(plain));
    EXPECT_EQ(crs.metres_per_unit(), 1);
    std::vector<Point> points = {{300000, 500000}};
    std::vector<Point> others = points;
    Transformation(crs, Crs::wgs84()).apply(points);
    Transformation(plain, Crs::wgs84()).apply(others);
    EXPECT_EQ(points[0], others[0]);
  }
}

// The way by which a .prj and a GeoPackage come.
TEST(Spheres, law_2_holds_for_the_systems_of_layers) {
  OGRSpatialReference system;
  ASSERT_EQ(system.importFromWkt(geogcs(zeros).c_str()), OGRERR_NONE);
  const auto crs = crs_from_system(system, "f.gpkg");
  ASSERT_TRUE(crs);
  EXPECT_FALSE(crs->wkt().starts_with("BOUNDCRS"));
  EXPECT_EQ(crs->name(), "sphere");
}

TEST(Spheres, a_system_without_code_and_name_is_called_by_its_text) {
  OGRSpatialReference system;
  ASSERT_EQ(system.SetFromUserInput("+proj=longlat +R=6370000 +no_defs"), OGRERR_NONE);
  EXPECT_EQ(crs_from_system(system, "f.fgb")->name(), "'+proj=longlat +R=6370000 +no_defs'");
}

TEST(Spheres, a_shift_of_an_ellipsoid_stays) {
  const Crs crs = Crs::from_text("+proj=longlat +ellps=bessel +towgs84=600,100,400", "CRS");
  std::vector<Point> points = {{10, 50}};
  Transformation(crs, Crs::wgs84()).apply(points);
  EXPECT_GT(std::abs(points[0].y - 50), 1e-4);
}

}  // namespace
}  // namespace thiessen
