#include "text/lines_of_files.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace thiessen {
namespace {

TEST(LinesOfFiles, the_lines_of_one_file_are_their_numbers) {
  LinesOfFiles lines;
  lines.begin("a");
  EXPECT_EQ(lines.number(1), 1U);
  EXPECT_EQ(lines.number(7), 7U);
  EXPECT_EQ(lines.place(7).file, "a");
  EXPECT_EQ(lines.place(7).line, 7U);
}

TEST(LinesOfFiles, no_two_lines_have_one_number) {
  LinesOfFiles lines;
  lines.begin("a");
  const std::size_t last_of_a = lines.number(3);
  lines.begin("empty");
  lines.begin("b");
  const std::size_t first_of_b = lines.number(1);
  EXPECT_GT(first_of_b, last_of_a);
  EXPECT_EQ(lines.place(last_of_a).file, "a");
  EXPECT_EQ(lines.place(last_of_a).line, 3U);
  EXPECT_EQ(lines.place(first_of_b).file, "b");
  EXPECT_EQ(lines.place(first_of_b).line, 1U);
}

}  // namespace
}  // namespace thiessen
