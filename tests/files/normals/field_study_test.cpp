#include "files/normals/field_study.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "files/normals/given_study.h"

namespace thiessen {
namespace {

std::shared_ptr<const NormalField> normals_in(GivenStudy& given) {
  given.normal_field = "normal";
  given.read();
  return normals_of_fields("normal", *given.study, *given.files);
}

std::vector<std::string> faults_in(GivenStudy& given) {
  std::vector<std::string> faults = complaints_of([&] { normals_in(given); });
  for (std::string& fault : faults) fault = fault.substr(fault.rfind('/') + 1);
  return faults;
}

/// A header's twelve fields, and a row's twelve values.
std::string months(const std::string& name) {
  std::string fields;
  for (int month = 1; month <= 12; ++month)
    fields += "," + name + (month < 10 ? "_0" : "_") + std::to_string(month);
  return fields;
}
std::string values(int first) {
  std::string row;
  for (int month = 0; month < 12; ++month) row += "," + std::to_string(first + month);
  return row;
}

std::string basin(const std::string& header, const std::string& row) {
  return "id" + header + ",WKT\nB" + row + ",\"POLYGON((0 0,8 0,8 4,0 4,0 0))\"\n";
}

TEST(NormalsOfFields, are_those_of_stations_and_basins) {
  GivenStudy given{.stations = "id,x,y,Normal\na,2,2,40\nb,6,2,80.5\n",
                   .basins = basin(",NORMAL", ",60")};
  const auto normals = normals_in(given);
  EXPECT_EQ(normals->months(), 1u);
  EXPECT_EQ(normals->at_gauge(StationIndex{1}, 0), 80.5);
  EXPECT_EQ(normals->in(0).whole(0).mean, 60);
}

TEST(NormalsOfFields, of_months_are_those_of_each) {
  GivenStudy given{.stations = "id,x,y" + months("normal") + "\na,2,2" + values(1) + "\nb,6,2" +
                               values(101) + "\n",
                   .basins = basin(months("normal"), values(51))};
  const auto normals = normals_in(given);
  EXPECT_EQ(normals->months(), 12u);
  EXPECT_EQ(normals->at_gauge(StationIndex{0}, 11), 12);
  EXPECT_EQ(normals->at_gauge(StationIndex{1}, 0), 101);
  EXPECT_EQ(normals->in(0).whole(2).mean, 53);
}

TEST(NormalsOfFields, that_are_none_are_told_all_at_once) {
  GivenStudy given{.stations = "id,x,y,normal\na,2,2,0\nb,6,2,\nc,7,2,-9999\n",
                   .basins = basin(",normal", ",-3")};
  EXPECT_EQ(faults_in(given),
            (std::vector<std::string>{
                "s.csv:2: station 'a' has the normal 0 in 'normal', and normals are above 0 | "
                "'stations_where' leaves stations out of the network",
                "s.csv:3: station 'b' has no normal in 'normal'",
                "s.csv:4: station 'c' has the normal -9999 in 'normal', and normals are above 0",
                "b.csv: basin 'B' has the normal -3 in 'normal', and normals are above 0 | "
                "'basins_where' leaves basins out"}));
}

TEST(NormalsOfFields, name_the_month_that_has_none) {
  GivenStudy given{.stations = "id,x,y" + months("normal") + "\na,2,2" + values(0) + "\nb,6,2" +
                               values(1) + "\n",
                   .basins = basin(months("normal"), values(1))};
  EXPECT_EQ(faults_in(given).at(0),
            "s.csv:2: station 'a' has the normal 0 in 'normal_01', and normals are above 0 | "
            "'stations_where' leaves stations out of the network");
}

TEST(NormalsOfFields, of_a_year_and_of_months_do_not_meet) {
  GivenStudy given{.stations = "id,x,y,normal\na,2,2,40\nb,6,2,80\n",
                   .basins = basin(months("normal"), values(51))};
  EXPECT_TRUE(contains(faults_in(given).at(0), "has twelve, of calendar months"))
      << faults_in(given).at(0);
}

}  // namespace
}  // namespace thiessen
