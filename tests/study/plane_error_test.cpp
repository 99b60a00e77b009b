#include "study/plane_error.h"

#include <gtest/gtest.h>

#include <memory>

namespace thiessen {
namespace {

TEST(PlaneError, finds_the_worst_change_also_of_a_gauge_that_weighs_on_one_side_only) {
  const std::vector<BasinWeights> plane = {
      {4, {{StationIndex{0}, 1, 0.25}, {StationIndex{2}, 3, 0.75}}},
      {2, {{StationIndex{1}, 2, 1}}}};
  const std::vector<BasinWeights> earth = {
      {2, {{StationIndex{0}, 0.6, 0.3}, {StationIndex{1}, 0.2, 0.1}, {StationIndex{2}, 1.2, 0.6}}},
      {4, {{StationIndex{1}, 4, 1}}}};
  const PlaneError error = error_of_plane(plane, earth, true);
  EXPECT_EQ(error.worst_change.basin, 0U);
  EXPECT_EQ(error.worst_change.station, StationIndex{2});
  EXPECT_NEAR(error.worst_change.size(), 0.15, 1e-15);
  EXPECT_TRUE(error.moves_weights());
  EXPECT_EQ(error.worst_area->basin, 0U);
  EXPECT_EQ(error.worst_area->factor, 2);
  EXPECT_FALSE(error_of_plane(plane, earth, false).worst_area);
}

TEST(PlaneError, a_plane_that_is_true_moves_nothing) {
  const std::vector<BasinWeights> weights = {{4, {{StationIndex{0}, 4, 1}}}};
  const PlaneError error = error_of_plane(weights, weights, true);
  EXPECT_EQ(error.worst_change.size(), 0);
  EXPECT_FALSE(error.moves_weights());
  EXPECT_FALSE(error.distorts_areas());
}

TEST(PlaneError, degrees_as_a_plane_at_latitude_60) {
  // Half as wide as they look: the bisector of (0, 60) and (1, 60.5) turns.
  const std::vector<Station> stations = {{"a", {0, 60}}, {"b", {1, 60.5}}};
  const Basin square{"Q", {{{{0, 60}, {1, 60}, {1, 61}, {0, 61}}, {}}}, {}};
  auto parts = std::make_shared<StudyParts>();
  parts->stations = stations;
  parts->basins = {square};
  parts->degrees_per_unit = 1;
  Warnings warnings;
  const Study study(parts, {}, warnings);
  StudyParts on_earth;
  on_earth.metric = Metric::geodesic;
  on_earth.stations = stations;
  on_earth.basins = {square};
  const PlaneError error = error_of_plane(study, on_earth, 1);
  // By hand: with v north of 60 the bisector is 2x + v = 1.25 in the plane, and a has 0.375 of the
  // square. With x shrunk by c = 0.49 it is c^2 (2x - 1) + v = 0.25, and a has 0.25.
  EXPECT_EQ(error.worst_change.in_plane > 0.5, error.worst_change.station == StationIndex{1});
  EXPECT_NEAR(error.worst_change.size(), 0.125, 0.01);
  EXPECT_FALSE(error.worst_area);
  EXPECT_NE(sentence_of(error, study).find("in basin 'Q'"), std::string::npos);
}

}  // namespace
}  // namespace thiessen
