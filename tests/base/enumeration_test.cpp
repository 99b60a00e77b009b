#include "base/enumeration.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

TEST(Enumeration, CountsWhatItDoesNotName) {
  const std::vector<std::string> texts = {"a", "b", "c"};
  EXPECT_EQ(enumerated(texts, 3), "a, b, c");
  EXPECT_EQ(enumerated(texts, 10), "a, b, c and 7 more");
  EXPECT_EQ(enumerated_up_to(2, texts), "a, b and 1 more");
  EXPECT_EQ(enumerated_up_to(3, texts), "a, b, c");
  EXPECT_EQ(enumerated_up_to(2, {}), "");
}

TEST(Enumeration, QuotesNamesAndCutsThem) {
  const std::vector<std::string> names = {"a", "long name", "c"};
  EXPECT_EQ(names_up_to(2, names, 4), "'a', 'long...' and 1 more");
}

}  // namespace
}  // namespace thiessen
