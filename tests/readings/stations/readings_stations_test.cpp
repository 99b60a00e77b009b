#include "readings/stations/readings_stations.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

using Standing = ReadingsStations::Standing;

class ReadingsStationsTest : public testing::Test {
 protected:
  const std::vector<Station> listed = {{"A", {}}, {" B", {}}, {"B", {}}, {"007", {}}};
  const std::vector<std::string> filtered = {"F", "G"};
  const ReadingsStations stations{listed, filtered};

  Standing standing(std::string_view text) const { return stations.find(text).standing; }
  std::size_t number(std::string_view text) const { return index(stations.find(text).station); }
};

TEST_F(ReadingsStationsTest, are_found_by_their_very_ids) {
  EXPECT_EQ(standing("A"), Standing::known);
  EXPECT_EQ(number("A"), 0U);
  EXPECT_EQ(number("007"), 3U);
  EXPECT_EQ(stations.id(StationIndex{3}), "007");
  EXPECT_EQ(stations.all().size(), 4U);
}

TEST_F(ReadingsStationsTest, ids_are_texts_and_not_numbers_or_words) {
  for (const char* text : {"7", "07", "a", "A.", "A B", ""})
    EXPECT_EQ(standing(text), Standing::unknown) << text;
}

TEST_F(ReadingsStationsTest, blanks_round_a_text_count_only_where_an_id_has_them) {
  EXPECT_EQ(number(" A\t"), 0U);
  EXPECT_EQ(number(" B"), 1U);
  EXPECT_EQ(number("B"), 2U);
  EXPECT_EQ(number("B "), 2U);
}

TEST_F(ReadingsStationsTest, those_left_out_by_a_filter_are_not_unknown) {
  EXPECT_EQ(standing("F"), Standing::passed_over);
  EXPECT_EQ(standing(" G "), Standing::passed_over);
  EXPECT_EQ(standing("f"), Standing::unknown);
}

}  // namespace
}  // namespace thiessen
