#include "readings/folded_warnings.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(FoldedWarnings, say_once_what_is_said_of_several_files) {
  FoldedWarnings folded;
  for (const char* file : {"a.csv", "b.csv", "c.csv"}) {
    Warnings warnings;
    warnings.add_notice({file, 0, "its fields are parted by tabs", ""});
    if (file[0] == 'b') warnings.add({file, 3, "odd", ""});
    folded.add(warnings);
  }
  Warnings all;
  folded.pass_on(all);
  ASSERT_EQ(all.notices().size(), 1U);
  EXPECT_EQ(all.notices()[0].sentence(),
            "a.csv: its fields are parted by tabs (and the same of 2 more files)");
  ASSERT_EQ(all.messages().size(), 1U);
  EXPECT_EQ(all.messages()[0].sentence(), "b.csv:3: odd");
}

}  // namespace
}  // namespace thiessen
