#include "files/plane_judgement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "earth/plane/conformal_plane.h"

namespace thiessen {
namespace {

/// Two gauges and a square basin between them, in a plane of this CRS; empty: of none.
struct Judged {
  std::string crs;
  std::vector<Point> gauges;
  Point corner;
  double side;
  Metric metric = Metric::planar;
  bool is_made = false;  ///< whether the plane was made for the study
  Warnings warnings = {};

  std::optional<PlaneError> error() {
    const auto files = std::make_shared<StudyFiles>();
    files->metric = metric;
    files->stations_file = "s.csv";
    if (!crs.empty()) {
      files->crs = Crs::from_text(crs, setting("crs"));
      files->degrees_per_unit = files->crs->degrees_per_unit();
      if (!files->crs->geographic()) files->metres_per_unit = files->crs->metres_per_unit();
    }
    files->stations_crs = files->basins_crs = files->crs;
    if (is_made) files->plane = StudyPlane{ConformalPlane({}), 0};
    for (const Point p : gauges)
      files->stations.push_back({"g" + std::to_string(files->stations.size()), p});
    const auto [x, y] = corner;
    files->basins = {
        {"B", {{{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, {}}}, {}}};
    files->native_basins = {files->basins[0].shape};
    Warnings of_study;
    const Study study(files, {}, of_study);
    return judge_plane(*files, study, 1, warnings);
  }
};

constexpr double mercators_60 = 8399737.89;  // the northing of 60 degrees: a ln tan 75

Judged in_web_mercator() {
  return {"EPSG:3857", {{100, mercators_60}, {1900, mercators_60 + 500}}, {0, mercators_60}, 2000};
}

TEST(PlaneJudgement, is_silent_where_there_is_no_plane_of_the_earth) {
  Judged geodesic = {"EPSG:4326", {{15, 50}, {15.1, 50}}, {15, 50}, 0.1, Metric::geodesic};
  EXPECT_FALSE(geodesic.error());
  EXPECT_TRUE(geodesic.warnings.messages().empty());
  Judged nowhere = {"", {{1, 1}, {2, 2}}, {0, 0}, 3};
  EXPECT_FALSE(nowhere.error());
  EXPECT_TRUE(nowhere.warnings.messages().empty());
}

// Along UTM's central meridian lengths are 0.9996 and areas 0.9992 of the Earth's, whose curvature
// shows in nothing over two kilometres.
TEST(PlaneJudgement, tells_a_small_error_without_a_warning) {
  Judged utm = {"EPSG:32633", {{499100, 5500000}, {500900, 5500500}}, {499000, 5500000}, 2000};
  const auto error = utm.error();
  ASSERT_TRUE(error);
  EXPECT_LT(error->worst_change.size(), 1e-6);
  EXPECT_NEAR(error->worst_area->factor, 0.9996 * 0.9996, 1e-6);
  EXPECT_TRUE(utm.warnings.messages().empty());
}

// Mercator's cylinder of the equator's radius a: an area is a^2 / (M N cos^2) of the Earth's.
TEST(PlaneJudgement, warns_of_areas_that_are_off) {
  Judged mercator = in_web_mercator();
  const auto error = mercator.error();
  ASSERT_TRUE(error);
  const double e2 = 0.00669437999014;
  const double s = std::sin(60.0045 * std::numbers::pi / 180);  // the middle of the square
  const double wanted = std::pow(1 - e2 * s * s, 2) / (1 - e2) / (1 - s * s);
  EXPECT_NEAR(error->worst_area->factor / wanted, 1, 1e-4);
  ASSERT_EQ(mercator.warnings.messages().size(), 1U);
  const Message& warning = mercator.warnings.messages()[0];
  EXPECT_TRUE(warning.sentence().starts_with("in the plane of EPSG:3857 ")) << warning.sentence();
  EXPECT_EQ(warning.hint.plain(),
            "metric = geodesic measures the Earth, and plane = auto finds the plane that distorts "
            "least");
}

TEST(PlaneJudgement, names_no_other_plane_beside_one_that_was_made) {
  Judged mercator = in_web_mercator();
  mercator.is_made = true;
  EXPECT_TRUE(mercator.error());
  ASSERT_EQ(mercator.warnings.messages().size(), 1U);
  const Message& warning = mercator.warnings.messages()[0];
  EXPECT_TRUE(warning.sentence().starts_with("in the plane made for the study "));
  EXPECT_EQ(warning.hint.plain(), "metric = geodesic measures the Earth");
}

// Degrees at 60 north are half as wide as high: gauges across a corner change places. They have no
// areas, and were warned of with the hint before.
TEST(PlaneJudgement, warns_of_weights_of_degrees_without_a_hint) {
  Judged degrees = {"EPSG:4326", {{0, 60}, {1, 60.5}}, {0, 60}, 1};
  const auto error = degrees.error();
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->worst_change.size(), 0.125, 0.01);  // by hand in tests/study
  EXPECT_FALSE(error->worst_area);
  ASSERT_EQ(degrees.warnings.messages().size(), 1U);
  EXPECT_TRUE(degrees.warnings.messages()[0].hint.empty());
}

TEST(PlaneJudgement, says_why_a_plane_cannot_be_judged) {
  Judged lost = {"EPSG:32633", {{500000, 5500000}, {9e7, 5500000}}, {499000, 5500000}, 2000};
  EXPECT_FALSE(lost.error());
  EXPECT_EQ(sentences_of(lost.warnings),
            (std::vector<std::string>{
                "s.csv: how far a plane's weights are from those on the Earth cannot be told: "
                "station 'g1' lies outside the projection's area"}));
}

}  // namespace
}  // namespace thiessen
