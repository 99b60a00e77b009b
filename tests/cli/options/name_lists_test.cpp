#include "cli/options/name_lists.h"

#include <gtest/gtest.h>

namespace thiessen::cli {
namespace {

using Names = std::vector<std::string>;

TEST(NameLists, ReadAsASentence) {
  EXPECT_EQ(and_list({}), "");
  EXPECT_EQ(and_list({"a"}), "a");
  EXPECT_EQ(and_list({"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(or_list({"a", "b"}), "a or b");
}

const Names options{"--metric", "--method", "--margin", "--missing", "--min-gauges", "--x"};

TEST(NearestNames, AMistypedName) {
  EXPECT_EQ(nearest_names("--metrik", options), Names{"--metric"});
  EXPECT_EQ(nearest_names("--methdo", options), Names{"--method"});
  EXPECT_EQ(nearest_names("-metric", options), Names{"--metric"});
  EXPECT_TRUE(nearest_names("--picture", options).empty());
}

TEST(NearestNames, AnAbbreviation) {
  EXPECT_EQ(nearest_names("--met", options), (Names{"--metric", "--method"}));
  EXPECT_EQ(nearest_names("--min", options), Names{"--min-gauges"});
}

TEST(NearestNames, NotWhatMaySayAnything) {
  EXPECT_TRUE(nearest_names("--m", options).empty());
  EXPECT_TRUE(nearest_names("--", options).empty());
  EXPECT_TRUE(nearest_names("", options).empty());
}

}  // namespace
}  // namespace thiessen::cli
