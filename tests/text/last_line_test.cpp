#include "text/last_line.h"

#include <gtest/gtest.h>

#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using namespace std::literals;

TEST(LastLine, has_an_end_unless_a_file_is_cut_off) {
  const TemporaryFolder folder;
  const auto ends_within = [&](std::string_view text) {
    return ends_within_line(folder.write("f.csv", text));
  };
  EXPECT_FALSE(ends_within("id,x\na,10.5\n"));
  EXPECT_FALSE(ends_within("id,x\r\na,10.5\r\n"));
  EXPECT_FALSE(ends_within("id,x\ra,10.5\r")) << "of an old Macintosh";
  EXPECT_FALSE(ends_within("i\0\n\0"sv)) << "UTF-16";
  EXPECT_FALSE(ends_within("\n"));
  EXPECT_TRUE(ends_within("id,x\na,10"));
  EXPECT_TRUE(ends_within("i"));
  EXPECT_TRUE(ends_within("i\0\n\0x\0"sv));
}

TEST(LastLine, is_not_asked_of_what_has_none) {
  const TemporaryFolder folder;
  EXPECT_FALSE(ends_within_line(folder.write("empty", "")));
  EXPECT_FALSE(ends_within_line(folder.path()));
  EXPECT_FALSE(ends_within_line(folder.write("r.zip", "PK\3\4 and what is packed")));
  EXPECT_FALSE(ends_within_line(folder.write("r.gz", "\x1f\x8b and what is packed")));
  EXPECT_FALSE(ends_within_line(folder.path("nowhere")));
  EXPECT_FALSE(ends_within_line("/dev/null"));
  EXPECT_FALSE(ends_within_line("-"));
}

}  // namespace
}  // namespace thiessen
