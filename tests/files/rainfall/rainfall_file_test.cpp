#include "files/rainfall/rainfall_file.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "readings/dly_text.h"

namespace thiessen {
namespace {

const std::vector<Station> stations = {{"USC00050001", {}}};

/// The first reading of the first step.
double first(const std::string& rainfall, const ReadingsOptions& options = {},
             char separator = '\0') {
  Warnings warnings;
  RainfallRequest request{{rainfall}, {}};
  request.said.csv.separator = separator;
  const auto readings = open_rainfall(request, stations, {}, options, warnings);
  TimeStep step;
  EXPECT_TRUE(readings->next(step));
  return step.readings[0];
}

TEST(RainfallFile, is_a_table_or_a_dly_file_or_a_folder_of_them_by_its_name) {
  const TemporaryFolder folder;
  const std::string dly = dly_line(stations[0].id, 2020, 1, {{1, {"125"}}}) + "\n";
  EXPECT_EQ(first(folder.write("a.dly", dly)), 12.5) << "tenths of a millimetre";
  EXPECT_EQ(first(folder.path()), 12.5);
  EXPECT_EQ(first(folder.write("r.csv", "time,USC00050001\n1,3.5\n")), 3.5);
  EXPECT_EQ(first(folder.write("s.csv", "time;USC00050001\n1;4.5\n"), {}, ';'), 4.5);
}

TEST(RainfallFile, flagged_values_are_kept_of_dly_files_alone) {
  const TemporaryFolder folder;
  ReadingsOptions options;
  options.keep_flagged = true;
  const std::string flagged = dly_line(stations[0].id, 2020, 1, {{1, {"125", " X "}}}) + "\n";
  EXPECT_EQ(first(folder.write("a.dly", flagged), options), 12.5);
  const std::string table = folder.write("r.csv", "time,USC00050001\n1,3.5\n");
  EXPECT_EQ(complaint_of([&] { first(table, options); }),
            table + ": 'keep_flagged' is for GHCN-Daily, whose values have flags of quality");
}

/// The readings of two stations, step by step, as `time a b`; `.` where one is silent.
std::vector<std::string> steps_of(const std::vector<std::string>& files,
                                  const ReadingsOptions& options, Warnings& warnings) {
  static const std::vector<Station> both = {{"A", {}}, {"B", {}}};
  const auto readings = open_rainfall({files, {}}, both, {}, options, warnings);
  std::vector<std::string> steps;
  for (TimeStep step; readings->next(step);) {
    std::string text = step.time;
    for (const double reading : step.readings)
      text += reading == reading ? " " + std::to_string(static_cast<int>(reading)) : " .";
    steps.push_back(text);
  }
  const ReportingStations heard = stations_that_report({files, {}}, both, {}, options);
  EXPECT_EQ(heard, (ReportingStations{true, true}));
  return steps;
}

TEST(RainfallFile, of_several_files_or_a_folder_of_a_file_a_station_is_one) {
  const TemporaryFolder folder;
  const std::string a = folder.write("p_A.csv", "date,rain\n2020-01-01,1\n2020-01-02,2\n");
  const std::string b = folder.write("p_B.csv", "date,rain\n2020-01-02,4\n");
  const std::vector<std::string> expected = {"2020-01-01 1 .", "2020-01-02 2 4"};
  Warnings warnings;
  EXPECT_EQ(steps_of({a, b}, {}, warnings), expected);
  EXPECT_EQ(steps_of({folder.path()}, {}, warnings), expected);
  folder.write("p_C.csv", "date,rain\n2020-01-02,9\n");
  EXPECT_TRUE(contains(complaint_of([&] { steps_of({folder.path()}, {}, warnings); }),
                       "nor does the file's name tell one"));
  ReadingsOptions options;
  options.ignore_unknown = true;
  EXPECT_EQ(steps_of({folder.path()}, options, warnings), expected);
}

TEST(RainfallFile, of_several_files_has_counters_that_go_on_from_file_to_file) {
  const TemporaryFolder folder;
  ReadingsOptions options;
  options.cumulative = true;
  Warnings warnings;
  EXPECT_EQ(steps_of({folder.write("2.csv", "time,A,B\n2020-01-01,9,10\n2020-01-02,9,15\n"),
                      folder.write("1.csv", "time,A,B\n2019-12-30,5,1\n2019-12-31,7,2\n")},
                     options, warnings),
            (std::vector<std::string>{"2019-12-30 . .", "2019-12-31 2 1", "2020-01-01 2 8",
                                      "2020-01-02 0 5"}));
}

constexpr const char* without_rain =
    "STATION,DATE,LATITUDE,LONGITUDE,ELEVATION,NAME,TMAX\nA,2020-01-01,1,2,3,a,111\n";
constexpr const char* sites =
    "agency_cd\tsite_no\tdatetime\t1_00060\n5s\t15s\t20d\t14n\nUSGS\tA\t2020-01-01\t7\n";

TEST(RainfallFile, of_several_passes_over_those_without_rain_and_names_them) {
  const TemporaryFolder folder;
  folder.write("1.csv", without_rain);
  folder.write("2.csv", "time,A,B\n2020-01-01,9,10\n");
  folder.write("3.txt", sites);
  Warnings warnings;
  EXPECT_EQ(steps_of({folder.path()}, {}, warnings), std::vector<std::string>{"2020-01-01 9 10"});
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].sentence(),
            folder.path() + ": files without rain are passed over: " + folder.path("1.csv") + ", " +
                folder.path("3.txt"));
}

TEST(RainfallFile, without_rain_in_any_of_several_is_an_error) {
  const TemporaryFolder folder;
  const std::string a = folder.write("1.csv", without_rain);
  const std::string b = folder.write("2.txt", sites);
  for (const std::vector<std::string>& named :
       {std::vector<std::string>{a, b}, std::vector<std::string>{folder.path()}}) {
    Warnings warnings;
    const auto found = complaints_of([&] { steps_of(named, {}, warnings); });
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0],
              a + ":1: it is NOAA's GHCN-Daily, a column an element, without a column of rain; the "
                  "columns are 'STATION', 'DATE', 'LATITUDE', 'LONGITUDE', 'ELEVATION', 'NAME', "
                  "'TMAX' | 'value_field' names one that is rain all the same");
    EXPECT_EQ(found[1], b + ": it is USGS's RDB without a column of precipitation (00045)");
  }
  EXPECT_TRUE(contains(complaint_of([&] { first(a); }), "without a column of rain"));
}

TEST(RainfallFile, without_a_header_is_filtered_by_the_names_of_its_format) {
  const TemporaryFolder folder;
  const std::string text =
      "USC00050001,20200101,TMAX,280,,,7,0700\nUSC00050001,20200102,PRCP,40,,,7,0700\n"
      "USC00050001,20200103,PRCP,50,,,7,0700\n";
  RainfallRequest request{{folder.write("r.csv", text)}, {}};
  request.said.where = "ELEMENT = 'PRCP' AND DATE > '20200102'";
  request.said.where_setting = "rainfall_where";
  Warnings warnings;
  const auto readings = open_rainfall(request, stations, {}, {}, warnings);
  TimeStep step;
  ASSERT_TRUE(readings->next(step));
  EXPECT_EQ(step.time, "20200103");
  EXPECT_EQ(step.readings[0], 5.0);
}

}  // namespace
}  // namespace thiessen
