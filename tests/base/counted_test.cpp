#include "base/counted.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(Counts, are_told_with_what_they_count) {
  EXPECT_EQ(counted(0, "row"), "0 rows");
  EXPECT_EQ(counted(1, "row"), "1 row");
  EXPECT_EQ(counted(2, "row"), "2 rows");
  EXPECT_EQ(counted(1, "reading is", "readings are"), "1 reading is");
  EXPECT_EQ(counted(21, "reading is", "readings are"), "21 readings are");
}

}  // namespace
}  // namespace thiessen
