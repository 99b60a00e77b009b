#include "rainfall/normals/window_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace thiessen {
namespace {

TEST(WindowValues, know_what_they_were_given) {
  for (const bool is_wide : {false, true}) {
    WindowValues values(2, 1, 1, is_wide);
    EXPECT_TRUE(std::isnan(values.at(0, 0, 0)));
    EXPECT_FALSE(values.is_complete());
    values.set(0, 0, 0, 3);
    values.set(0, 0, 1, std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(values.is_complete());
    values.set(0, 0, 1, -2);
    EXPECT_TRUE(values.is_complete());
    EXPECT_EQ(values.least(), -2);
    EXPECT_EQ(values.largest(), 3);
    EXPECT_EQ(values.at(0, 0, 0), 3);
  }
}

// Four bytes hold 0.1 only nearly.
TEST(WindowValues, are_wide_where_they_have_to_be) {
  WindowValues narrow(1, 1, 1, false);
  narrow.set(0, 0, 0, 0.1);
  EXPECT_EQ(narrow.at(0, 0, 0), static_cast<double>(0.1F));
  WindowValues wide(1, 1, 1, true);
  wide.set(0, 0, 0, 0.1);
  EXPECT_EQ(wide.at(0, 0, 0), 0.1);
}

}  // namespace
}  // namespace thiessen
