#include "base/hidden_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

#include "base/destination.h"
#include "base/outputs.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Names = std::set<std::string>;

std::string left_over(const TemporaryFolder& folder, const std::string& text) {
  return folder.write(name_in_folder(fresh_name(folder.path())), text);
}

TEST(HiddenFile, law_1_has_no_name_until_it_gets_one_that_is_free) {
  const TemporaryFolder folder;
  const Descriptor file = open_unnamed(folder.path(), 0644);
  if (!file.is_open()) GTEST_SKIP() << "the file system has no files without names";
  ASSERT_EQ(::write(file.number(), "x", 1), 1);
  EXPECT_TRUE(folder.names().empty());
  ASSERT_EQ(give_name(file, folder.path("a")), 0);
  EXPECT_EQ(folder.read("a"), "x");
  folder.write("b", "theirs");
  EXPECT_EQ(give_name(file, folder.path("b")), -1);
  EXPECT_EQ(errno, EEXIST);
}

TEST(HiddenFile, law_2_what_a_killed_run_left_is_removed_by_the_next) {
  const TemporaryFolder folder;
  left_over(folder, "half");
  const std::string hidden = fresh_name(folder.path());
  std::filesystem::create_directory(hidden);
  std::ofstream(hidden + "/map.tif") << "half";
  folder.write("a.csv", "old");
  ASSERT_EQ(::link(folder.path("a.csv").c_str(), backup_name(folder.path("a.csv")).c_str()), 0);
  folder.write(".thiessen-short", "a user's own");
  { const FolderInUse next(folder.path()); }
  EXPECT_EQ(folder.names(), (Names{".thiessen-short", "a.csv"}));
}

TEST(HiddenFile, law_3_what_a_run_is_using_stays) {
  const TemporaryFolder folder;
  std::optional<FolderInUse> first(folder.path());
  const std::string used = left_over(folder, "half");
  { const FolderInUse second(folder.path()); }
  EXPECT_EQ(folder.names(), (Names{name_in_folder(used)}));
  first.reset();
  { const FolderInUse third(folder.path()); }
  EXPECT_TRUE(folder.names().empty());
}

TEST(HiddenFile, law_4_the_only_copy_of_an_older_file_stays_until_it_is_replaced_once_more) {
  const TemporaryFolder folder;
  const std::string copy = backup_name(folder.path("a.csv"));
  EXPECT_TRUE(copy.ends_with("-a.csv"));
  folder.write(name_in_folder(copy), "old");
  FolderInUse next(folder.path());
  EXPECT_EQ(folder.names(), (Names{name_in_folder(copy)}));
  next.forget(folder.path("b.csv"));
  EXPECT_EQ(folder.names(), (Names{name_in_folder(copy)}));
  next.forget(folder.path("a.csv"));
  EXPECT_TRUE(folder.names().empty());
}

TEST(HiddenFile, law_4_holds_for_names_that_agree_as_far_as_a_copy_tells_them) {
  const TemporaryFolder folder;
  const std::string long_name(200, 'a');
  const std::string copy = name_in_folder(backup_name(folder.path(long_name + "1.csv")));
  folder.write(copy, "old");
  FolderInUse next(folder.path());
  next.forget(folder.path(long_name + "2.csv"));
  next.forget(folder.path(long_name));
  EXPECT_EQ(folder.names(), (Names{copy}));
}

/// Whether another run could have the folder for itself.
bool is_free(const TemporaryFolder& folder) {
  const Descriptor other = open_descriptor(folder.path(), O_RDONLY | O_DIRECTORY);
  return ::flock(other.number(), LOCK_EX | LOCK_NB) == 0;
}

TEST(HiddenFile, law_3_holds_beside_a_run_that_takes_long_to_remove_what_is_left) {
  const TemporaryFolder folder;
  Descriptor slow = open_descriptor(folder.path(), O_RDONLY | O_DIRECTORY);
  struct flock mark = {};
  mark.l_type = F_RDLCK;
  ASSERT_EQ(::flock(slow.number(), LOCK_EX), 0);
  if (::fcntl(slow.number(), F_OFD_SETLK, &mark) != 0) GTEST_SKIP() << "folders have no such locks";
  std::optional<FolderInUse> used;
  std::thread run([&] { used.emplace(folder.path()); });
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  slow.close();
  run.join();
  EXPECT_FALSE(is_free(folder));
  used.reset();
  EXPECT_TRUE(is_free(folder));
}

TEST(HiddenFile, a_program_that_keeps_the_folder_for_itself_is_not_waited_for) {
  const TemporaryFolder folder;
  const Descriptor other = open_descriptor(folder.path(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(other.number(), LOCK_EX), 0);
  { const FolderInUse used(folder.path()); }
}

TEST(HiddenFile, law_5_a_run_that_is_killed_before_its_end_leaves_nothing) {
  const TemporaryFolder folder;
  if (!open_unnamed(folder.path(), 0644).is_open()) {
    GTEST_SKIP() << "the file system has no files without names";
  }
  const pid_t child = ::fork();
  if (child == 0) {
    Outputs outputs({true, {}});
    outputs.make_folder(folder.path("out"));
    outputs.add(folder.path("out/a.csv")).append(std::string(1'000'000, 'x'));
    outputs.add(folder.path("b.csv")).append(std::string(1'000'000, 'x'));
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_TRUE(folder.names().empty());
}

TEST(HiddenFile, law_6_a_name_of_any_length_has_a_backup) {
  const TemporaryFolder folder;
  const std::string longest = folder.write(std::string(255, 'a'), "old");
  EXPECT_EQ(::link(longest.c_str(), backup_name(longest).c_str()), 0) << errno;
}

}  // namespace
}  // namespace thiessen
