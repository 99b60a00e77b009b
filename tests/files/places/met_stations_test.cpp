#include "files/places/met_stations.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace thiessen {
namespace {

/// A list of stations, each of which is put there unless its id was met before.
class List {
 public:
  /// The station of the same id that came before; null where there is none.
  const Station* meet(const Station& station) {
    const Station* const first = met_.meet(station.id);
    if (first == nullptr) stations_.push_back(station);
    return first;
  }

 private:
  std::vector<Station> stations_;
  MetStations met_{stations_};
};

void expect_found(List& list, const std::vector<std::string>& ids) {
  for (std::size_t i = 0; i < ids.size(); ++i) ASSERT_EQ(list.meet({ids[i], {}, i}), nullptr);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Station* const first = list.meet({ids[i], {}, 0});
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->line, i);
  }
}

TEST(MetStations, are_found_again_as_they_came_first) {
  List list;
  EXPECT_EQ(list.meet({"a", {1, 2}, 3}), nullptr);
  EXPECT_EQ(list.meet({"", {3, 4}, 5}), nullptr);
  EXPECT_EQ(list.meet({"A", {1, 2}, 6}), nullptr);
  const Station* const first = list.meet({"a", {7, 8}, 9});
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->id, "a");
  EXPECT_EQ(first->position, (Point{1, 2}));
  EXPECT_EQ(first->line, 3U);
}

TEST(MetStations, may_be_many) {
  List list;
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < 5000; ++i)
    ids.push_back("station " + std::to_string(i * 7919 % 5003));
  expect_found(list, ids);
}

TEST(MetStations, are_found_where_their_ids_ascend) {
  List list;
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < 5000; ++i) ids.push_back(std::to_string(i));
  expect_found(list, ids);
}

TEST(MetStations, are_found_at_once_where_one_repeats_the_last) {
  List list;
  EXPECT_EQ(list.meet({"1", {}, 1}), nullptr);
  EXPECT_EQ(list.meet({"2", {}, 2}), nullptr);
  const Station* const first = list.meet({"2", {}, 3});
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->line, 2U);
}

}  // namespace
}  // namespace thiessen
