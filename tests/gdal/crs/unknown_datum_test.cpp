#include "gdal/crs/unknown_datum.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

Crs crs(const std::string& text) {
  return Crs::from_text(text, setting("crs"));
}

TEST(UnknownDatum, a_sphere_has_no_flattening) {
  EXPECT_TRUE(on_sphere(crs("+proj=longlat +R=6370000")));
  EXPECT_TRUE(on_sphere(crs("EPSG:4047")));
  EXPECT_FALSE(on_sphere(Crs::wgs84()));
  EXPECT_FALSE(on_sphere(crs("EPSG:3857"))) << "its formulas are a sphere's, its datum is WGS 84";
}

/// CRSs by what is known of where their datum lies.
const std::vector<std::string> near_wgs84 = {"EPSG:4326",
                                             "EPSG:4269",
                                             "EPSG:32633",
                                             "+proj=longlat +ellps=GRS80",
                                             "+proj=utm +zone=33 +ellps=WGS84",
                                             "+proj=longlat +R=6370000",
                                             "EPSG:4047"};
const std::vector<std::string> far_off = {"EPSG:4004", "EPSG:4314", "+proj=longlat +ellps=intl",
                                          "+proj=longlat +a=6378249 +rf=293.4"};

TEST(UnknownDatum, law_1_spheres_and_modern_ellipsoids_may_stand_for_one_another) {
  for (const std::string& a : near_wgs84) {
    for (const std::string& b : near_wgs84)
      EXPECT_TRUE(may_be_taken_over(crs(a), crs(b))) << a << ' ' << b;
  }
}

TEST(UnknownDatum, law_2_no_other_ellipsoid_stands_for_one_of_these_in_either_direction) {
  for (const std::string& a : near_wgs84) {
    for (const std::string& b : far_off) {
      EXPECT_FALSE(may_be_taken_over(crs(a), crs(b))) << a << ' ' << b;
      EXPECT_FALSE(may_be_taken_over(crs(b), crs(a))) << a << ' ' << b;
    }
  }
}

TEST(UnknownDatum, two_crss_that_name_one_ellipsoid_and_no_datum_are_on_one) {
  EXPECT_TRUE(may_be_taken_over(crs("EPSG:4004"), crs("+proj=utm +zone=33 +ellps=bessel")));
  EXPECT_TRUE(
      may_be_taken_over(crs("+proj=longlat +ellps=intl"), crs("+proj=utm +zone=33 +ellps=intl")));
  EXPECT_FALSE(may_be_taken_over(crs("EPSG:4004"), crs("+proj=longlat +ellps=intl")));
  EXPECT_FALSE(may_be_taken_over(crs("EPSG:4004"), crs("EPSG:4314")))
      << "DHDN is a datum on this ellipsoid, and may be another one";
}

TEST(UnknownDatum, the_refusal_names_both_sides_and_the_ellipsoid_that_is_to_blame) {
  for (const bool back : {false, true}) {
    const Crs from = back ? Crs::wgs84() : crs("EPSG:4004");
    const Crs to = back ? crs("EPSG:4004") : Crs::wgs84();
    EXPECT_EQ(complaint_of([&] { fail_for_datum(from, to); }),
              "no transformation of datum from " + from.name() + " to " + to.name() +
                  " is known: coordinates on 'Bessel 1841' without a known datum may be hundreds "
                  "of metres off | name a CRS whose datum is known; metric = planar, or 'plane' "
                  "with a projected CRS of the same datum, needs no datum");
  }
  EXPECT_TRUE(contains(
      complaint_of([] { fail_for_datum(crs("+proj=longlat +a=6378249 +rf=293.4"), Crs::wgs84()); }),
      "coordinates on 'its ellipsoid' without"));
}

TEST(UnknownDatum, what_proj_lacks_is_named) {
  EXPECT_EQ(
      complaint_of([] { fail_for_grid(crs("EPSG:4267"), Crs::wgs84(), "conus"); }),
      "no transformation of datum from EPSG:4267 to EPSG:4326 can be had: PROJ lacks the grid "
      "'conus' | the packages proj-data and proj-datumgrid, or projsync, bring grids");
  EXPECT_EQ(complaint_of([] { fail_for_projection(crs("EPSG:4267"), Crs::wgs84()); }),
            "PROJ cannot transform from EPSG:4267 to EPSG:4326: it lacks the projection");
}

}  // namespace
}  // namespace thiessen
