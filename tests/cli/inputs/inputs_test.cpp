#include "cli/inputs/inputs.h"

#include <cmath>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "cli/inputs/given_rainfall.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {
namespace {

using Texts = std::vector<std::string>;

/// The notices about the stations that make the network.
Texts notices_of_network(const Warnings& warnings) {
  Texts found;
  for (const Message& notice : warnings.notices()) {
    const std::string sentence = notice.sentence();
    if (contains(sentence, "the network")) found.push_back(sentence.substr(sentence.find("s.csv")));
  }
  return found;
}

TEST(Inputs, law_1_the_network_is_of_the_stations_with_at_least_one_reading) {
  GivenRainfall given("time,A,B,C\n2013-08-01,1,,\n2013-08-02,,2,\n");
  const Inputs inputs = given.inputs();
  EXPECT_EQ(ids_of(inputs.network().stations()), (Texts{"A", "B"}));
  EXPECT_EQ(ids_of(inputs.never_reporting()), Texts{"C"});
  EXPECT_TRUE(notices_of_network(given.warnings).empty());
  EXPECT_EQ(inputs.all_report().size(), 2U);
  EXPECT_TRUE(inputs.has_basins());
  ASSERT_EQ(inputs.basins().size(), 1U);
  EXPECT_EQ(inputs.basins()[0].id, "Q");
}

TEST(Inputs, without_rainfall_the_network_is_of_all_stations_and_a_notice_says_so) {
  GivenRainfall given("");
  EXPECT_EQ(ids_of(given.inputs().network().stations()), (Texts{"A", "B", "C"}));
  ASSERT_EQ(notices_of_network(given.warnings).size(), 1U);
  EXPECT_TRUE(notices_of_network(given.warnings)[0].starts_with(
      "s.csv: all 3 stations make the network, whether they report or not: there is no "))
      << notices_of_network(given.warnings)[0];
  GivenRainfall alone("", {}, "id,x,y\nA,0,2\n");
  EXPECT_EQ(alone.inputs().network().stations().size(), 1U);
  EXPECT_TRUE(contains(notices_of_network(alone.warnings).at(0),
                       "its one station makes the network, whether it reports or not"));
}

TEST(Inputs, of_rainfall_that_can_be_read_only_once_take_all_stations) {
  GivenRainfall given("-");
  EXPECT_EQ(given.inputs().network().stations().size(), 3U);
  bool is_told = false;
  for (const Message& notice : given.warnings.notices())
    is_told = is_told || contains(notice.sentence(), "is read only once");
  EXPECT_TRUE(is_told);
}

TEST(Inputs, of_an_event_are_of_the_stations_that_have_its_reading) {
  GivenRainfall given("", {"--value-field", "rain"}, "id,x,y,rain\nA,0,2,12.5\nB,8,2,\nC,9,3,0\n");
  Inputs inputs = given.inputs();
  EXPECT_EQ(ids_of(inputs.network().stations()), (Texts{"A", "C"}));
  const auto readings = inputs.open_readings(given.study(), given.rainfall(), given.warnings);
  const GaugeReadings event = read_gauges(*readings, inputs.network(), "");
  EXPECT_EQ(event.readings, (std::vector<double>{12.5, 0}));
}

// A reading of a station that is known and not wanted is no fault; one of nobody is.
TEST(Inputs, readings_of_stations_that_are_left_out_are_passed_over_in_silence) {
  GivenRainfall given("time,A,B,C\n2013-08-01,1,2,3\n", {"--stations-where", "id <> 'B'"});
  Inputs inputs = given.inputs();
  EXPECT_EQ(ids_of(inputs.network().stations()), (Texts{"A", "C"}));
  const auto readings = inputs.open_readings(given.study(), given.rainfall(), given.warnings);
  EXPECT_EQ(read_gauges(*readings, inputs.network(), "").readings, (std::vector<double>{1, 3}));
  EXPECT_EQ(sentences_of(given.warnings), Texts{});
  GivenRainfall unknown("time,A,B,X\n2013-08-01,1,2,3\n");
  Inputs others = unknown.inputs();
  EXPECT_TRUE(contains(complaint_of([&] {
                         const auto opened = others.open_readings(
                             unknown.study(), unknown.rainfall(), unknown.warnings);
                         read_gauges(*opened, others.network(), "");
                       }),
                       "'X'"));
}

}  // namespace
}  // namespace thiessen::cli
