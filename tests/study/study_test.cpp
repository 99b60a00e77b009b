#include "study/study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>

#include "base/complaints.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

/// A study of these stations, without basins and in a plane unless it is told otherwise.
struct Given {
  explicit Given(std::vector<Station> stations) {
    parts->stations = std::move(stations);
    parts->has_basins = false;
    parts->stations_file = "s.csv";
    parts->basins_file = "b.csv";
    parts->opened_from = "opened";
  }

  Texts warned() {
    Warnings warnings;
    const Study study(parts, settings, warnings);
    return sentences_of(warnings);
  }
  Texts faults() {
    Warnings warnings;
    return complaints_of([&] { const Study study(parts, settings, warnings); });
  }

  std::shared_ptr<StudyParts> parts = std::make_shared<StudyParts>();
  StudySettings settings = {};
};

const std::vector<Station> corners = {{"a", {0, 0}}, {"b", {4, 0}}, {"c", {4, 2}}};

TEST(Study, without_basins_weighs_the_extent_of_its_stations_with_a_margin) {
  for (const auto& [margin, area] : {std::pair(0.0, 8.0), std::pair(25.0, 6.0 * 4)}) {
    Given given(corners);
    given.settings.margin = margin;  // percent of the larger side, 4
    Warnings warnings;
    const Study study(given.parts, given.settings, warnings);
    ASSERT_EQ(study.basins().size(), 1U);
    EXPECT_EQ(study.weighing().weights(study.all_report(), 1)[0].area, area);
    EXPECT_TRUE(warnings.messages().empty());
  }
}

TEST(Study, of_stations_without_extent_wants_basins_or_a_margin) {
  Given given({{"a", {0, 0}}, {"b", {4, 0}}});
  EXPECT_EQ(given.faults(),
            Texts{"s.csv: the stations have no extent to make a study area of | give 'basins', or "
                  "a 'margin' above 0 where they lie on one line"});
  Given grown({{"a", {0, 0}}, {"b", {4, 0}}});
  grown.settings.margin = 10;
  EXPECT_EQ(grown.warned(), Texts{});
}

TEST(Study, names_stations_at_one_place_but_those_that_a_what_if_opens) {
  Given given(corners);
  given.parts->stations.push_back({"d", {4, -0.0}});
  given.parts->stations.push_back({"with 1", {0, 0}});
  given.parts->opened = 1;
  EXPECT_EQ(given.warned(),
            Texts{"s.csv: stations 'b', 'd' stand at one place and share its cell"});
}

TEST(Study, names_five_stations_of_five_places_and_counts_the_others) {
  Given given({});
  for (int place = 0; place < 7; ++place) {
    for (int i = 0; i < 7; ++i) {
      const Point at = {1.0 * place, 1.0 * place * place};
      given.parts->stations.push_back({std::to_string(place) + std::to_string(i), at});
    }
  }
  const Texts warned = given.warned();
  ASSERT_EQ(warned.size(), 6U);
  EXPECT_EQ(warned[4],
            "s.csv: stations '40', '41', '42', '43', '44' and 2 more stand at one place "
            "and share its cell");
  EXPECT_EQ(warned[5], "s.csv: 2 more places have several stations");
}

// Three times the double 0.1 is more than the double 0.3.
TEST(Study, tells_of_a_line_in_a_plane_where_it_is_one_to_the_last_bit) {
  const Texts line = {"s.csv: the stations lie on one line: their cells are strips"};
  EXPECT_EQ(Given({{"a", {0, 0}}, {"b", {1, 3}}, {"c", {2, 6}}, {"d", {-1, -3}}}).warned(), line);
  EXPECT_EQ(Given({{"a", {0, 0}}, {"b", {0.1, 0.3}}, {"c", {1, 3}}}).warned(), Texts{});
  EXPECT_EQ(Given({{"a", {0, 0}}, {"b", {1, 3}}}).warned(), Texts{}) << "two always do";
  Given on_earth({{"a", {0, 0}}, {"b", {1, 3}}, {"c", {2, 6}}});
  on_earth.parts->metric = Metric::geodesic;
  EXPECT_EQ(on_earth.warned(), Texts{});
}

TEST(Study, refuses_every_coordinate_outside_the_exact_range_with_its_place) {
  Given given(
      {{"a", {0, 1e-43}, 3}, {"b", {4e60, 0}, 4}, {"c", {1, 2}, 5}, {"with 1", {0, -1e61}}});
  given.parts->opened = 1;
  given.parts->has_basins = true;
  given.parts->basins = {{"B", {{{{0, 0}, {1, 0}, {1, 1e70}}, {}}}, {}},
                         {"C", {{{{0, 0}, {1, 0}, {1, 1}}, {}}}, {}}};
  const std::string range = " is outside the supported range: 0, or 1.8e-43 to 3.2e60 in magnitude";
  const Texts by_feature = {"s.csv: a coordinate of station 'a' (feature 3)" + range,
                            "s.csv: a coordinate of station 'b' (feature 4)" + range,
                            "opened: a coordinate of station 'with 1'" + range,
                            "b.csv: a coordinate of basin 'B'" + range};
  EXPECT_EQ(given.faults(), by_feature);
  given.parts->stations_have_lines = true;
  EXPECT_EQ(given.faults()[1], "s.csv:4: a coordinate of station 'b'" + range);
}

TEST(Study, areas_are_square_kilometres_where_the_unit_is_known) {
  const auto km2 = [](Metric metric, std::optional<double> unit) {
    Given given(corners);
    given.parts->metric = metric;
    given.parts->metres_per_unit = unit;
    Warnings warnings;
    return Study(given.parts, {}, warnings).km2_per_area();
  };
  EXPECT_EQ(km2(Metric::planar, std::nullopt), 1);
  EXPECT_EQ(km2(Metric::planar, 0.3048), 1e-6);
  EXPECT_EQ(km2(Metric::geodesic, std::nullopt), 1e-6);
}

TEST(SettingRange, holds_its_ends) {
  EXPECT_TRUE(tolerances.holds(1e-3));
  EXPECT_TRUE(tolerances.holds(1e6));
  EXPECT_FALSE(tolerances.holds(0.0009));
  EXPECT_FALSE(margins.holds(-1e-9));
  EXPECT_FALSE(plane_units.holds(std::nan("")));
}

}  // namespace
}  // namespace thiessen
