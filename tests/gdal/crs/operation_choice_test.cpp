#include "gdal/crs/operation_choice.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

Crs crs(const std::string& text) {
  return Crs::from_text(text, setting("crs"));
}

OperationChoice choice(const std::string& from, const std::optional<Box>& area = {}) {
  return choose_operation(crs(from), Crs::wgs84(), area);
}

// Translations by DMA's TR8350.2 (in EPSG's registry too): they depend on where one is.
TEST(OperationChoice, is_the_one_that_is_made_for_the_area) {
  const struct {
    const char* from;
    Box area;
    const char* translation;
  } places[] = {{"EPSG:4267", {{-102, 20}, {-100, 22}}, "+x=-12 +y=130 +z=190"},  // Mexico
                {"EPSG:4267", {{-90, 14}, {-88, 15}}, "+x=0 +y=125 +z=194"},      // Central America
                {"EPSG:4301", {{127, 35}, {128, 36}}, "+x=-147 +y=506 +z=687"}};  // Korea
  for (const auto& [from, area, translation] : places) {
    const OperationChoice chosen = choice(from, area);
    EXPECT_TRUE(contains(chosen.steps, translation)) << chosen.steps;
    EXPECT_TRUE(contains(chosen.name, " to WGS 84")) << chosen.name;
    EXPECT_TRUE(chosen.accuracy.has_value());
  }
}

// EPSG:1155: 217 m, 823 m, 299 m, to within 21 m.
TEST(OperationChoice, has_the_name_and_the_accuracy_of_its_authority) {
  const OperationChoice indian = choice("EPSG:4239");
  EXPECT_EQ(indian.name, "Indian 1954 to WGS 84 (1)");
  EXPECT_EQ(indian.accuracy, 21);
  EXPECT_TRUE(contains(indian.steps, "+x=217 +y=823 +z=299"));
  EXPECT_EQ(indian.sphere, "");
}

TEST(OperationChoice, of_an_area_over_the_antimeridian_is_found) {
  // Fiji 1986 is used from 176.81 to -178.15.
  const OperationChoice fiji = choice("EPSG:4720", Box{{178, -18}, {181, -16}});
  EXPECT_TRUE(contains(fiji.name, "Fiji 1986 to W")) << fiji.name;
}

// New Zealand's grid ends long before Thailand; a translation does not.
TEST(OperationChoice, is_none_with_a_grid_that_does_not_reach_all_of_the_area) {
  EXPECT_TRUE(contains(choice("EPSG:4272", Box{{168, -46}, {178, -35}}).steps, "grid"));
  EXPECT_FALSE(contains(choice("EPSG:4272", Box{{100, 15}, {101, 16}}).steps, "grid"));
}

TEST(OperationChoice, law_1_is_the_same_whenever_it_is_asked_for) {
  const Box area = {{5, 50}, {10, 55}};
  const OperationChoice once = choice("EPSG:4230", area);
  choice("EPSG:4230", Box{{-9, 37}, {-7, 42}});
  const OperationChoice again = choice("EPSG:4230", area);
  EXPECT_EQ(once.steps, again.steps);
  EXPECT_EQ(once.name, again.name);
  EXPECT_EQ(once.accuracy, again.accuracy);
}

TEST(OperationChoice, takes_a_sphere_for_wgs84_and_says_so) {
  const OperationChoice sphere = choice("+proj=longlat +R=6370000");
  EXPECT_TRUE(contains(sphere.sphere, "R=6370000"));
  EXPECT_FALSE(sphere.accuracy.has_value());
  EXPECT_EQ(choice("+proj=longlat +ellps=GRS80").sphere, "");
}

TEST(OperationChoice, refuses_a_datum_that_nobody_knows_and_a_grid_that_is_not_there) {
  EXPECT_TRUE(contains(complaint_of([] { choice("EPSG:4004"); }),
                       "no transformation of datum from EPSG:4004 to EPSG:4326 is known"));
  EXPECT_TRUE(contains(
      complaint_of([] { choice("+proj=longlat +ellps=clrk66 +nadgrids=no_such_grid.gsb"); }),
      "PROJ lacks the grid 'no_such_grid.gsb'"));
}

TEST(RoughOperation, needs_no_datum_but_the_grid_that_the_crs_itself_names) {
  const auto bessel = choose_rough_operation(crs("+proj=utm +zone=33 +ellps=bessel"));
  ASSERT_TRUE(bessel);
  EXPECT_TRUE(contains(bessel->steps, "+proj=utm +zone=33"));
  EXPECT_FALSE(
      choose_rough_operation(crs("+proj=longlat +ellps=clrk66 +nadgrids=no_such_grid.gsb")));
}

// NADCON's grid of the United States is more accurate than any translation, where it is not there.
TEST(BetterGrid, is_one_that_is_not_installed_and_more_accurate) {
  const Box kansas = {{-100, 37}, {-96, 39}};
  const std::string grid = better_grid(crs("EPSG:4267"), Crs::wgs84(), kansas, 7);
  EXPECT_TRUE(grid.empty() || contains(grid, "conus")) << grid;
  EXPECT_EQ(better_grid(crs("EPSG:4267"), Crs::wgs84(), kansas, 0), "");
  EXPECT_EQ(better_grid(crs("EPSG:4171"), Crs::wgs84(), Box{{0, 45}, {5, 48}}, 1), "")
      << "RGF93 is WGS 84 to within a metre";
}

}  // namespace
}  // namespace thiessen
