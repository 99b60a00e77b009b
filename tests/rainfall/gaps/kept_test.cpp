// Values that are kept by numbers.
#include "rainfall/gaps/kept.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace thiessen {
namespace {

TEST(Kept, keeps_the_first_value_of_a_number) {
  Kept<std::string> kept(3, 1000);
  EXPECT_EQ(kept.find(1), nullptr);
  EXPECT_EQ(*kept.keep(1, std::make_unique<const std::string>("a"), 0), "a");
  EXPECT_EQ(*kept.keep(1, std::make_unique<const std::string>("b"), 0), "a");
  EXPECT_EQ(*kept.find(1), "a");
  EXPECT_EQ(kept.find(2), nullptr);
}

TEST(Kept, gives_back_what_is_beyond_the_bound) {
  Kept<std::string> kept(2, 1000);
  EXPECT_EQ(*kept.keep(0, std::make_unique<const std::string>("a"), 2000), "a");
  EXPECT_EQ(kept.find(0), nullptr);
  kept.keep(0, std::make_unique<const std::string>("a"), 600);
  kept.keep(1, std::make_unique<const std::string>("b"), 600);
  EXPECT_NE(kept.find(0), nullptr);
  EXPECT_EQ(kept.find(1), nullptr);
}

}  // namespace
}  // namespace thiessen
