#include "readings/dly/dly_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

TEST(DlyFiles, are_known_by_their_name) {
  const TemporaryFolder folder;
  EXPECT_TRUE(is_dly("x/USC00050001.dly"));
  EXPECT_TRUE(is_dly("X.DLY"));
  EXPECT_TRUE(is_dly(folder.path()));
  EXPECT_FALSE(is_dly("-"));
  EXPECT_FALSE(is_dly("dly"));
  EXPECT_FALSE(is_dly("a.dly.csv"));
  EXPECT_FALSE(is_dly(folder.write("a.csv", "")));
}

TEST(DlyFiles, of_a_file_are_this_file_whether_it_is_there_or_not) {
  EXPECT_EQ(dly_files("nowhere/a.dly"), std::vector<std::string>{"nowhere/a.dly"});
}

TEST(DlyFiles, of_a_folder_are_those_of_this_name_in_the_order_of_their_names) {
  const TemporaryFolder folder;
  for (const char* name : {"b.dly", "A.DLY", "c.dly", "a.dly", "readme.txt", "d.dly~", "dly"})
    folder.write(name, "");
  EXPECT_EQ(dly_files(folder.path()),
            (std::vector<std::string>{folder.path("A.DLY"), folder.path("a.dly"),
                                      folder.path("b.dly"), folder.path("c.dly")}));
}

TEST(DlyFiles, a_folder_without_any_is_an_error_whatever_lies_below_it) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("below"));
  folder.write("below/a.dly", "");
  EXPECT_EQ(complaint_of([&] { dly_files(folder.path()); }),
            folder.path() +
                ": is a folder without a .dly file | readings are a table, or .dly "
                "files of GHCN-Daily");
}

}  // namespace
}  // namespace thiessen
