#include "readings/dly/seekable_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

struct Line {
  std::string text;
  LinePlace place;
};

std::vector<Line> lines_from(SeekableLines& lines) {
  std::vector<Line> all;
  while (const auto line = lines.next()) all.push_back({std::string(*line), lines.place()});
  return all;
}

TEST(SeekableLines, end_in_lf_or_crlf_and_have_places) {
  const TemporaryFolder folder;
  const std::string file = folder.write("f", "ab\n\nc\r\nd\re\n");
  SeekableLines lines;
  lines.go(file, {});
  const std::vector<Line> all = lines_from(lines);
  ASSERT_EQ(all.size(), 4U);
  const std::pair<const char*, std::uint64_t> expected[] = {
      {"ab", 0}, {"", 3}, {"c", 4}, {"d\re", 7}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(all[i].text, expected[i].first);
    EXPECT_EQ(all[i].place.offset, expected[i].second);
    EXPECT_EQ(all[i].place.line, i + 1);
  }
}

TEST(SeekableLines, the_last_one_need_not_end) {
  const TemporaryFolder folder;
  SeekableLines lines;
  lines.go(folder.write("f", "a\nb"), {});
  EXPECT_EQ(lines.next(), "a");
  EXPECT_TRUE(lines.ends());
  EXPECT_EQ(lines.next(), "b");
  EXPECT_FALSE(lines.ends());
  EXPECT_EQ(lines.next(), std::nullopt);
  lines.go(folder.write("g", ""), {});
  EXPECT_EQ(lines.next(), std::nullopt);
}

TEST(SeekableLines, law_1_from_any_place_on_are_the_same_lines) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const TemporaryFolder folder;
  const auto text = [&](char c) {
    std::string all;
    for (int i = 0; i < 3000; ++i) all += std::string(random() % 200, c) + std::to_string(i) + "\n";
    return all;
  };
  const std::string files[] = {folder.write("f", text('x')), folder.write("g", text('y'))};
  SeekableLines lines;
  std::vector<Line> all[2];
  for (int f = 0; f < 2; ++f) {
    lines.go(files[f], {});
    all[f] = lines_from(lines);
    ASSERT_EQ(all[f].size(), 3000U);
  }
  std::size_t at = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::size_t f = random() % 20 == 0 ? 1 : 0;
    at = random() % 2 == 0 ? random() % 3000 : (at + 3) % 3000;  // far off, or near by
    lines.go(files[f], all[f][at].place);
    for (std::size_t i = at; i < std::min<std::size_t>(at + 3, 3000); ++i) {
      ASSERT_EQ(lines.next(), all[f][i].text);
      ASSERT_EQ(lines.place().offset, all[f][i].place.offset);
      ASSERT_EQ(lines.place().line, i + 1);
    }
  }
}

TEST(SeekableLines, are_of_bounded_length) {
  const TemporaryFolder folder;
  SeekableLines lines;
  lines.go(folder.write("f", std::string(SeekableLines::longest_line, 'x') + "\n"), {});
  EXPECT_EQ(lines.next()->size(), SeekableLines::longest_line);
  const std::string file =
      folder.write("g", "a\n" + std::string(SeekableLines::longest_line + 1, 'x'));
  lines.go(file, {});
  EXPECT_EQ(lines.next(), "a");
  EXPECT_EQ(complaint_of([&] { lines.next(); }),
            file + ":2: the line is longer than 4096 bytes, the limit");
}

TEST(SeekableLines, are_those_of_plain_files_that_are_there) {
  const TemporaryFolder folder;
  SeekableLines lines;
  EXPECT_EQ(complaint_of([&] { lines.go(folder.path("no"), {}); }),
            folder.path("no") + ": cannot open: No such file or directory");
  for (const std::string& name : {folder.path(), std::string("/dev/null")})
    EXPECT_EQ(complaint_of([&] { lines.go(name, {}); }),
              name + ": is no plain file, which can be read twice");
}

}  // namespace
}  // namespace thiessen
