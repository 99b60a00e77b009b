// A file that a run adds to: locked, and grown in place so far as it was kept.
#include "base/grown_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <thread>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

TEST(GrownFile, grows_in_place_and_keeps_what_was_kept) {
  const TemporaryFolder folder;
  folder.write("r.csv", "time,A\n1,2\ncut");
  {
    GrownFile file(folder.path("r.csv"), {});
    ASSERT_TRUE(file.exists());
    EXPECT_EQ(file.size(), 14U);
    std::array<char, 20> bytes{};
    EXPECT_EQ(file.read(7, bytes), 7U);
    OutputFile& output = file.grow(11);
    output.append("2,3\n");
    file.keep();
    EXPECT_EQ(folder.read("r.csv"), "time,A\n1,2\n2,3\n");
    output.append("3,4\n");
    output.flush();
    EXPECT_EQ(folder.read("r.csv"), "time,A\n1,2\n2,3\n3,4\n");
  }
  EXPECT_EQ(folder.read("r.csv"), "time,A\n1,2\n2,3\n");
}

TEST(GrownFile, that_is_new_goes_where_nothing_of_it_was_kept) {
  const TemporaryFolder folder;
  {
    GrownFile file(folder.path("r.csv"), {});
    EXPECT_FALSE(file.exists());
    file.grow(0).append("time,A\n");
  }
  EXPECT_NE(::access(folder.path("r.csv").c_str(), F_OK), 0);
  {
    GrownFile file(folder.path("r.csv"), {});
    file.grow(0).append("time,A\n");
    file.keep();
  }
  EXPECT_EQ(folder.read("r.csv"), "time,A\n");
}

TEST(GrownFile, waits_for_another_run_that_adds_to_it) {
  const TemporaryFolder folder;
  folder.write("r.csv", "time,A\n");
  auto first = std::make_unique<GrownFile>(folder.path("r.csv"), OutputRules{});
  std::thread run([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    first->grow(7).append("1,2\n");
    first->keep();
    first.reset();
  });
  const GrownFile second(folder.path("r.csv"), {});
  EXPECT_EQ(second.size(), 11U);
  run.join();
}

TEST(GrownFile, is_not_replaced_where_it_has_changed) {
  const TemporaryFolder folder;
  folder.write("r.csv", "time,A\n");
  const GrownFile file(folder.path("r.csv"), {});
  file.require_unchanged();
  folder.write("r.csv", "time,A\n1,2\n");
  EXPECT_TRUE(contains(complaint_of([&] { file.require_unchanged(); }),
                       "has changed while steps were to be added to it"));
}

TEST(GrownFile, is_a_plain_file_and_no_link_nor_input) {
  const TemporaryFolder folder;
  folder.write("r.csv", "");
  ASSERT_EQ(::symlink("r.csv", folder.path("link.csv").c_str()), 0);
  const auto refused = [&](const std::string& path, const OutputRules& rules) {
    return complaint_of([&] { const GrownFile file(path, rules); });
  };
  EXPECT_TRUE(contains(refused(folder.path("link.csv"), {}), "is a symbolic link"));
  EXPECT_TRUE(contains(refused("/dev/null", {}), "is no plain file"));
  EXPECT_TRUE(contains(refused("-", {}), "is no plain file"));
  EXPECT_TRUE(contains(refused(folder.path("r.csv"), {false, {folder.path("r.csv")}}),
                       "is an input of this run"));
}

}  // namespace
}  // namespace thiessen
