#include "files/rainfall/full_network.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"

namespace thiessen {
namespace {

StudyFiles study_of(const std::vector<std::string>& ids) {
  StudyFiles study;
  study.attributes.fields = {{"place", FieldType::text}};
  for (const std::string& id : ids) {
    study.stations.push_back({id, {static_cast<double>(study.stations.size()), 0}});
    study.attributes.rows.push_back({"at " + id});
  }
  return study;
}

std::vector<std::string> ids_of(const std::vector<Station>& stations) {
  std::vector<std::string> ids;
  for (const Station& station : stations) ids.push_back(station.id);
  return ids;
}

using Texts = std::vector<std::string>;

TEST(FullNetwork, is_of_the_stations_that_report_in_their_order_with_their_attributes) {
  StudyFiles study = study_of({"a", "b", "c", "d"});
  Warnings warnings;
  keep_full_network(study, {false, true, false, true}, "r.csv", warnings);
  EXPECT_EQ(ids_of(study.stations), (Texts{"b", "d"}));
  EXPECT_EQ(study.stations[1].position, (Point{3, 0}));
  EXPECT_EQ(study.attributes.rows, (std::vector<Texts>{{"at b"}, {"at d"}}));
  EXPECT_EQ(ids_of(study.never_reporting), (Texts{"a", "c"}));
  EXPECT_EQ(sentences_of(warnings), (Texts{"r.csv: 2 stations have no readings, and no part in "
                                           "the network: 'a', 'c'"}));
  EXPECT_TRUE(warnings.notices().empty());
}

TEST(FullNetwork, is_silent_where_all_report) {
  StudyFiles study = study_of({"a", "b"});
  Warnings warnings;
  keep_full_network(study, {true, true}, "r.csv", warnings);
  EXPECT_EQ(ids_of(study.stations), (Texts{"a", "b"}));
  EXPECT_EQ(study.attributes.rows.size(), 2U);
  EXPECT_TRUE(study.never_reporting.empty());
  EXPECT_TRUE(warnings.messages().empty());
  EXPECT_TRUE(warnings.notices().empty());
}

TEST(FullNetwork, is_of_all_stations_where_none_reports) {
  StudyFiles study = study_of({"a", "b"});
  Warnings warnings;
  keep_full_network(study, {false, false}, "r.csv", warnings);
  EXPECT_EQ(ids_of(study.stations), (Texts{"a", "b"}));
  EXPECT_TRUE(study.never_reporting.empty());
  EXPECT_TRUE(warnings.messages().empty());
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].sentence(),
            "r.csv: no station has a reading: all 2 are taken for the network");
}

TEST(FullNetwork, needs_no_attributes) {
  StudyFiles study = study_of({"a", "b"});
  study.attributes = {};
  Warnings warnings;
  keep_full_network(study, {false, true}, "r.csv", warnings);
  EXPECT_EQ(ids_of(study.stations), (Texts{"b"}));
  EXPECT_TRUE(study.attributes.rows.empty());
}

}  // namespace
}  // namespace thiessen
