#include "study/similar_ids.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

using Ids = std::vector<std::string>;

Ids similar(const std::string& id, const Ids& ids) {
  std::vector<Station> stations;
  for (const std::string& one : ids) stations.push_back({one, {}});
  return similar_ids(id, stations);
}

TEST(SimilarIds, are_those_of_stations_that_differ_least_in_file_order) {
  EXPECT_EQ(similar("A-l", {"B-1", "A-2", "A-1", "A-100"}), (Ids{"A-2", "A-1"}));
  EXPECT_EQ(similar("OAK", {"pine", "oak"}), Ids{"oak"});
}

TEST(SimilarIds, are_three_at_most_and_may_be_none) {
  EXPECT_EQ(similar("A-0", {"A-5", "A-4", "A-3", "A-2"}), (Ids{"A-5", "A-4", "A-3"}));
  EXPECT_EQ(similar("A-0", {"pine", "oak"}), Ids{});
  EXPECT_EQ(similar("A-0", {}), Ids{});
}

}  // namespace
}  // namespace thiessen
