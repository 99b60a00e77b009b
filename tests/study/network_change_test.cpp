#include "study/network_change.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/complaints.h"

namespace thiessen {
namespace {

/// Three gauges over a basin of 6 by 2, and one more that opens.
class NetworkChangeTest : public testing::Test {
 protected:
  NetworkChangeTest() : study_(parts({4, 1}), {}, warnings_) { warnings_ = {}; }

  static std::shared_ptr<StudyParts> parts(Point opened) {
    auto parts = std::make_shared<StudyParts>();
    parts->stations = {{"A-1", {1, 1}}, {"A-2", {3, 1}}, {"far", {90, 1}}, {"with 1", opened}};
    parts->opened = 1;
    parts->opened_from = "opened";
    parts->basins = {{"B", {{{{0, 0}, {6, 0}, {6, 2}, {0, 2}}, {}}}, {}}};
    parts->metres_per_unit = 1;
    return parts;
  }
  NetworkChange change(std::vector<std::string> closed) const {
    return {study_, std::move(closed), {"left"}, "closed"};
  }
  std::vector<std::string> faults(std::vector<std::string> closed) const {
    return complaints_of([&] { change(std::move(closed)); });
  }

  Warnings warnings_;
  Study study_;
};

TEST_F(NetworkChangeTest, before_has_all_but_what_opens_and_after_all_but_what_closes) {
  const NetworkChange without = change({"A-2"});
  EXPECT_EQ(without.before(), (ReportingStations{true, true, true, false}));
  EXPECT_EQ(without.after(), (ReportingStations{true, false, true, true}));
}

TEST_F(NetworkChangeTest, an_id_that_is_not_there_is_answered_with_the_most_similar) {
  EXPECT_EQ(faults({"A-l"}),
            std::vector<std::string>{"'without' names station 'A-l', which is not there | did you "
                                     "mean 'A-1' or 'A-2'?"});
  EXPECT_EQ(faults({"left"}),
            std::vector<std::string>{
                "'without' names station 'left', which 'stations_where' leaves out"});
}

TEST_F(NetworkChangeTest, a_gauge_that_opens_cannot_be_closed_by_its_made_up_id) {
  EXPECT_EQ(faults({"with 1"}).size(), 1U);
}

TEST_F(NetworkChangeTest, what_weighs_in_no_basin_changes_nothing_and_is_told) {
  const NetworkChange closing = change({"far"});
  Warnings warnings;
  closing.warn_of_no_effect(study_.weighing().weights(closing.before(), 1),
                            study_.weighing().weights(closing.after(), 1), warnings);
  ASSERT_EQ(warnings.messages().size(), 1U);
  EXPECT_EQ(warnings.messages()[0].sentence(),
            "closed: station 'far' weighs in no basin: nothing changes");
}

TEST_F(NetworkChangeTest, a_gauge_that_opens_beside_another_shares_its_cell_unless_that_closes) {
  Warnings making;
  const Study beside(parts({3, 1}), {}, making);
  Warnings warnings;
  NetworkChange(beside, {}, {}, "closed").warn_of_shared_places(warnings);
  EXPECT_EQ(warnings.messages().size(), 1U);
  NetworkChange(beside, {"A-2"}, {}, "closed").warn_of_shared_places(warnings);
  EXPECT_EQ(warnings.messages().size(), 1U);
}

}  // namespace
}  // namespace thiessen
