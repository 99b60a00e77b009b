#include "base/last_words.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen {
namespace {

TEST(LastWords, are_those_that_were_noted_last) {
  note_last_words("a.tif: cannot write: Input/output error");
  note_last_words("b.tif: cut");
  EXPECT_EQ(last_words(), "b.tif: cut");
  note_last_words(std::string(600, 'x'));
  EXPECT_EQ(last_words(), std::string(500, 'x'));
  note_last_words({});
  EXPECT_EQ(last_words(), "");
}

}  // namespace
}  // namespace thiessen
