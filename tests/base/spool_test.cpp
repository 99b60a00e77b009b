#include "base/spool.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "base/error.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

std::string whole(const Descriptor& spool) {
  std::string all;
  copy_spool(spool, [&](std::string_view text) { all += text; });
  return all;
}

/// The variable for the length of a test.
class Setting {
 public:
  explicit Setting(const std::string& value) { ::setenv("TMPDIR", value.c_str(), 1); }
  ~Setting() { ::unsetenv("TMPDIR"); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;
};

TEST(Spool, gives_back_all_that_was_written_however_often_it_is_asked) {
  const Descriptor spool = open_spool();
  EXPECT_EQ(whole(spool), "");
  const std::string text(700'001, 'x');
  ASSERT_EQ(::write(spool.number(), text.data(), text.size()), 700'001);
  EXPECT_EQ(whole(spool), text);
  EXPECT_EQ(whole(spool), text);
}

TEST(Spool, gives_back_what_was_written_at_a_place) {
  const Descriptor spool = open_spool();
  ASSERT_EQ(::write(spool.number(), "0123456789", 10), 10);
  std::string into(4, '-');
  EXPECT_EQ(read_spool(spool, 3, into), 4u);
  EXPECT_EQ(into, "3456");
  EXPECT_EQ(read_spool(spool, 8, into), 2u) << "it ends there";
  EXPECT_EQ(into, "8956");
  EXPECT_EQ(read_spool(spool, 10, into), 0u);
}

TEST(Spool, has_no_name_in_its_folder) {
  const TemporaryFolder folder;
  const Setting setting(folder.path());
  const Descriptor spool = open_spool();
  ASSERT_EQ(::write(spool.number(), "x", 1), 1);
  EXPECT_TRUE(folder.names().empty());
}

TEST(Spool, needs_no_folder_of_the_user) {
  const Setting setting("/nowhere/at/all");
  const Descriptor spool = open_spool();
  ASSERT_EQ(::write(spool.number(), "x", 1), 1);
  EXPECT_EQ(whole(spool), "x");
}

}  // namespace
}  // namespace thiessen
