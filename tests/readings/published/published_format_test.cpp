#include "readings/published/published_format.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace thiessen {
namespace {

TEST(PublishedFormat, a_column_may_have_several_names) {
  EXPECT_EQ(published_column({"STN", "VALUE"}, "DATA_VALUE|VALUE"), 1U);
  EXPECT_EQ(published_column({"STN", "data value"}, "DATA_VALUE|VALUE"), 1U);
  EXPECT_FALSE(published_column({"STN", "VAL"}, "DATA_VALUE|VALUE"));
}

TEST(PublishedFormat, a_star_is_the_end_of_how_a_name_begins) {
  EXPECT_TRUE(has_published_name("PRECIPITA\u00c7\u00c3O TOTAL, HOR\u00c1RIO (mm)",
                                 "PRECIPITA\u00c7\u00c3O TOTAL*"));
  EXPECT_TRUE(has_published_name("precipita\u00e7\u00e3o total", "PRECIPITA\u00c7\u00c3O TOTAL*"));
  EXPECT_FALSE(has_published_name("PRECIPITA\u00c7\u00c3O", "PRECIPITA\u00c7\u00c3O TOTAL*"));
  EXPECT_FALSE(has_published_name("TOTAL RAIN", "TOTAL"));
}

TEST(PublishedFormat, parted_texts_lose_their_blanks) {
  EXPECT_EQ(parted(" a , b,", ','), (std::vector<std::string_view>{"a", "b", ""}));
}

}  // namespace
}  // namespace thiessen
