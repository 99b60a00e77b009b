#include "files/rainfall/event_readings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

constexpr const char* gauges = "name,id,x,y,rain_in\nFirst,A,0,0,1\nSecond,B,1,0,\nThird,C,0,1,2\n";

struct Event {
  TemporaryFolder folder;
  StationsRequest request;
  ReadingsOptions options;
  std::vector<Station> stations = {{"A", {}}, {"B", {}}, {"C", {}}};
  Warnings warnings;

  explicit Event(const std::string& text) {
    request.source.file = folder.write("s.csv", text);
    options.value_field = "rain_in";
  }
};

TEST(EventReadings, are_one_step_of_a_field_of_the_stations) {
  Event event(gauges);
  const auto readings =
      open_event(event.request, event.stations, {}, event.options, event.warnings);
  TimeStep step;
  ASSERT_TRUE(readings->next(step));
  EXPECT_EQ(step.time, "event");
  ASSERT_EQ(step.readings.size(), 3U);
  EXPECT_EQ(step.readings[0], 25.4) << "the field's name says inches";
  EXPECT_TRUE(std::isnan(step.readings[1]));
  EXPECT_EQ(step.readings[2], 50.8);
  EXPECT_EQ(readings->unit(), "mm");
  EXPECT_FALSE(readings->next(step));
}

TEST(EventReadings, make_the_network_of_the_gauges_that_have_one) {
  Event event(gauges);
  const ReportingStations heard =
      stations_in_event(event.request, event.stations, {}, event.options);
  EXPECT_TRUE(heard[StationIndex{0}]);
  EXPECT_FALSE(heard[StationIndex{1}]);
  EXPECT_TRUE(heard[StationIndex{2}]);
}

TEST(EventReadings, pass_over_what_the_filter_leaves_out) {
  Event event(gauges);
  event.request.source.where = "id <> 'A'";
  event.stations = {{"B", {}}, {"C", {}}};
  const std::vector<std::string> left_out = {"A"};
  const auto readings =
      open_event(event.request, event.stations, left_out, event.options, event.warnings);
  TimeStep step;
  ASSERT_TRUE(readings->next(step));
  EXPECT_EQ(step.readings[1], 50.8);
}

TEST(EventReadings, name_the_line_of_a_reading_that_is_no_number) {
  Event event("id,x,y,rain_in\nA,0,0,1\nB,1,0,wet\nC,0,1,-2\n");
  const std::string file = event.request.source.file;
  const auto readings =
      open_event(event.request, event.stations, {}, event.options, event.warnings);
  TimeStep step;
  EXPECT_EQ(complaint_of([&] { readings->next(step); }),
            file +
                ":3: reading 'wet' of station 'B' is no number | missing = wet takes it for a gap, "
                "trace = wet for 0");
}

TEST(EventReadings, want_a_field_that_is_there) {
  Event event("id,x,y,rain\nA,0,0,1\n");
  const std::string file = event.request.source.file;
  EXPECT_EQ(complaint_of([&] {
              open_event(event.request, event.stations, {}, event.options, event.warnings);
            }),
            file + ":1: 'value_field': no field 'rain_in'; found 'id', 'x', 'y', 'rain'");
}

}  // namespace
}  // namespace thiessen
