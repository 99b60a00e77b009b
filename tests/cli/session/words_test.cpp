#include "cli/session/words.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace thiessen::cli {
namespace {

using Words = std::vector<std::string>;

TEST(Words, ArePartedByBlanks) {
  EXPECT_EQ(words_of("add 1  2\t3 "), (Words{"add", "1", "2", "3"}));
  EXPECT_TRUE(words_of(" \t").empty());
}

TEST(Words, InQuotesHoldBlanks) {
  EXPECT_EQ(words_of("load 'a b' \"c'd\""), (Words{"load", "a b", "c'd"}));
  EXPECT_EQ(words_of("load ''"), (Words{"load", ""}));
}

TEST(Words, EndWhereACommentBegins) {
  EXPECT_EQ(words_of("add 1 2 # here"), (Words{"add", "1", "2"}));
  EXPECT_EQ(words_of("load a#b '#c'"), (Words{"load", "a#b", "#c"}));
}

TEST(Words, RefuseAQuoteThatIsNeverClosed) {
  EXPECT_THROW(words_of("load 'a b"), Error);
}

}  // namespace
}  // namespace thiessen::cli
