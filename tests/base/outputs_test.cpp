#include "base/outputs.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "base/interrupt.h"
#include "base/sentence_of.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Names = std::set<std::string>;

std::string refusal(const std::string& path, const OutputRules& rules) {
  return sentence_of([&] { Outputs(rules).add(path); });
}

mode_t mode_of(const std::string& path) {
  struct stat status = {};
  EXPECT_EQ(::lstat(path.c_str(), &status), 0);
  return status.st_mode & 07777;
}

const OutputRules replacing = {true, {}};

TEST(Outputs, appear_when_all_are_committed_and_not_before) {
  const TemporaryFolder folder;
  Outputs outputs({});
  outputs.add(folder.path("a.csv")).append("one");
  outputs.add(folder.path("b.csv")).append("two");
  EXPECT_FALSE(folder.names().contains("a.csv"));
  outputs.commit();
  EXPECT_EQ(folder.names(), (Names{"a.csv", "b.csv"}));
  EXPECT_EQ(folder.read("a.csv"), "one");
  EXPECT_EQ(folder.read("b.csv"), "two");
}

TEST(Outputs, remove_side_files_of_the_older_output_with_it) {
  const TemporaryFolder folder;
  folder.write("a.shp", "old");
  folder.write("a.qix", "old");
  Outputs outputs(replacing);
  outputs.add(folder.path("a.shp")).append("new");
  outputs.remove(folder.path("a.qix"));
  outputs.remove(folder.path("a.sbn"));
  EXPECT_EQ(folder.read("a.qix"), "old");
  outputs.commit();
  EXPECT_EQ(folder.names(), (Names{"a.shp"}));
  EXPECT_EQ(folder.read("a.shp"), "new");
}

TEST(Outputs, keep_the_side_files_where_they_fail) {
  const TemporaryFolder folder;
  folder.write("a.qix", "old");
  {
    Outputs outputs(replacing);
    outputs.remove(folder.path("a.qix"));
    outputs.add(folder.path("a.shp")).append("new");
    outputs.add(folder.path("b")).append("new");
    std::filesystem::create_directory(folder.path("b"));
    EXPECT_THROW(outputs.commit(), Error);
  }
  EXPECT_EQ(folder.names(), (Names{"a.qix", "b"}));
  EXPECT_EQ(folder.read("a.qix"), "old");
  EXPECT_EQ(sentence_of([&] { Outputs({}).remove(folder.path("a.qix")); }),
            folder.path("a.qix") + " exists already");
}

TEST(Outputs, leave_nothing_behind_unless_committed) {
  const TemporaryFolder folder;
  folder.write("b.csv", "old");
  {
    Outputs outputs(replacing);
    outputs.add(folder.path("a.csv")).append("one");
    outputs.add(folder.path("b.csv")).append("two");
    outputs.make_folder(folder.path("dir"));
    outputs.add(folder.path("dir/c.csv"));
    std::ofstream(outputs.add_foreign(folder.path("dir/d.gpkg"))) << "three";
    EXPECT_TRUE(folder.names().contains("dir")) << "a library needs it";
  }
  EXPECT_EQ(folder.names(), (Names{"b.csv"}));
  EXPECT_EQ(folder.read("b.csv"), "old");
}

TEST(Outputs, replace_a_file_only_when_told_to) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "old");
  try {
    Outputs({}).add(path);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.messages()[0].sentence(), path + " exists already");
    EXPECT_EQ(error.messages()[0].hint, setting("overwrite") + " replaces it");
  }
  Outputs outputs(replacing);
  outputs.add(path).append("new");
  outputs.commit();
  EXPECT_EQ(folder.read("a.csv"), "new");
  EXPECT_EQ(folder.names(), (Names{"a.csv"}));
}

TEST(Outputs, keep_the_mode_of_what_they_replace) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "old");
  ::chmod(path.c_str(), 0640);
  Outputs outputs(replacing);
  outputs.add(path);
  std::ofstream(outputs.add_foreign(folder.write("b.gpkg", ""))) << "x";
  ::chmod(folder.path("b.gpkg").c_str(), 0604);
  outputs.commit();
  EXPECT_EQ(mode_of(path), 0640u);
  EXPECT_EQ(mode_of(folder.path("b.gpkg")), 0604u);
}

TEST(Outputs, leave_the_mode_of_new_files_to_the_umask) {
  const TemporaryFolder folder;
  const mode_t old = ::umask(027);
  Outputs outputs({});
  outputs.add(folder.path("a.csv"));
  outputs.commit();
  ::umask(old);
  EXPECT_EQ(mode_of(folder.path("a.csv")), 0640u);
}

TEST(Outputs, never_touch_an_input_whatever_it_is_called) {
  const TemporaryFolder folder;
  const std::string input = folder.write("in.csv", "data");
  ASSERT_EQ(::symlink("in.csv", folder.path("link").c_str()), 0);
  ASSERT_EQ(::link(input.c_str(), folder.path("hard").c_str()), 0);
  for (const bool overwrite : {false, true}) {
    for (const char* name : {"in.csv", "link", "hard", "./in.csv"}) {
      const std::string path = folder.path(name);
      EXPECT_EQ(refusal(path, {overwrite, {"PG:dbname=x", input}}),
                path + " is an input of this run, and would be lost");
    }
  }
  EXPECT_EQ(folder.read("in.csv"), "data");
}

TEST(Outputs, replace_a_link_and_not_what_it_leads_to) {
  const TemporaryFolder folder;
  folder.write("target", "old");
  const std::string link = folder.path("link");
  ASSERT_EQ(::symlink("target", link.c_str()), 0);
  EXPECT_EQ(refusal(link, {}), link + " exists already");
  Outputs outputs(replacing);
  outputs.add(link).append("new");
  outputs.commit();
  EXPECT_EQ(folder.read("target"), "old");
  EXPECT_EQ(folder.read("link"), "new");
  EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(link)));
}

TEST(Outputs, refuse_names_that_no_file_can_have) {
  const TemporaryFolder folder;
  const std::string dangling = folder.path("dangling");
  const std::string loop = folder.path("loop");
  ASSERT_EQ(::symlink("nowhere", dangling.c_str()), 0);
  ASSERT_EQ(::symlink("loop", loop.c_str()), 0);
  const std::string cannot = ": cannot write: ";
  EXPECT_EQ(refusal(folder.path(), replacing), folder.path() + cannot + "Is a directory");
  EXPECT_EQ(refusal(folder.path("new/"), replacing),
            folder.path("new/") + cannot + "Is a directory");
  EXPECT_EQ(refusal("", replacing), "the name of an output is empty");
  EXPECT_EQ(refusal(dangling, replacing),
            dangling + cannot + "a symbolic link that leads nowhere: No such file or directory");
  EXPECT_EQ(
      refusal(loop, replacing),
      loop + cannot + "a symbolic link that leads nowhere: Too many levels of symbolic links");
  EXPECT_EQ(refusal(folder.path("no/a.csv"), {}),
            folder.path("no/a.csv") + cannot + "No such file or directory");
  EXPECT_EQ(folder.names(), (Names{"dangling", "loop"}));
}

TEST(Outputs, refuse_to_write_one_file_twice) {
  const TemporaryFolder folder;
  Outputs outputs({});
  outputs.add(folder.path("a.csv"));
  const std::string same = folder.path() + "/./a.csv";
  EXPECT_EQ(sentence_of([&] { outputs.add(same); }), same + " would be written twice");
  EXPECT_EQ(sentence_of([&] { outputs.add_foreign(same); }), same + " would be written twice");
}

TEST(Outputs, refuse_to_write_one_file_twice_in_a_folder_that_is_not_made_yet) {
  const TemporaryFolder folder;
  const std::string path = folder.path("new/a.csv");
  const std::string same = folder.path("new//a.csv");
  Outputs outputs({});
  outputs.make_folder(folder.path("new"));
  outputs.make_folder(folder.path("other"));
  outputs.add(path);
  EXPECT_EQ(sentence_of([&] { outputs.add(path); }), path + " would be written twice");
  EXPECT_EQ(sentence_of([&] { outputs.add(same); }), same + " would be written twice");
  EXPECT_EQ(sentence_of([&] { outputs.add(folder.path("other/a.csv")); }), "no error");
}

TEST(Outputs, forget_the_copies_of_side_files_that_a_killed_run_left) {
  const TemporaryFolder folder;
  folder.write(name_in_folder(backup_name(folder.path("a.qix"))), "old");
  const std::string other = folder.write(name_in_folder(backup_name(folder.path("b.qix"))), "old");
  Outputs outputs({});
  outputs.add(folder.path("a.shp")).append("new");
  outputs.remove(folder.path("a.qix"));
  outputs.commit();
  EXPECT_EQ(folder.names(), (Names{"a.shp", name_in_folder(other)}));
}

TEST(Outputs, do_not_replace_a_file_that_appears_meanwhile) {
  const TemporaryFolder folder;
  Outputs outputs({});
  outputs.add(folder.path("a.csv")).append("ours");
  outputs.add(folder.path("b.csv")).append("ours");
  folder.write("b.csv", "theirs");
  EXPECT_EQ(sentence_of([&] { outputs.commit(); }), folder.path("b.csv") + " exists already");
  EXPECT_FALSE(folder.names().contains("a.csv"));
  EXPECT_EQ(folder.read("b.csv"), "theirs");
}

/// Makes the last output fail when the others are renamed already: a folder cannot replace a file.
void fail_at_the_last(const TemporaryFolder& folder, bool older_files) {
  if (older_files) {
    folder.write("a.csv", "old a");
    folder.write("b.csv", "old b");
  }
  folder.write("c.csv", "old c");
  {
    Outputs outputs(replacing);
    outputs.add(folder.path("a.csv")).append("new a");
    outputs.add(folder.path("b.csv")).append("new b");
    std::filesystem::create_directory(outputs.add_foreign(folder.path("c.csv")));
    EXPECT_EQ(sentence_of([&] { outputs.commit(); }),
              folder.path("c.csv") + ": cannot write: Not a directory");
  }
  EXPECT_EQ(folder.read("c.csv"), "old c");
  std::filesystem::remove(folder.path("c.csv"));
}

TEST(Outputs, are_taken_back_where_a_later_one_fails) {
  const TemporaryFolder folder;
  fail_at_the_last(folder, false);
  EXPECT_TRUE(folder.names().empty());
  fail_at_the_last(folder, true);
  EXPECT_EQ(folder.names(), (Names{"a.csv", "b.csv"}));
  EXPECT_EQ(folder.read("a.csv"), "old a");
  EXPECT_EQ(folder.read("b.csv"), "old b");
}

TEST(Outputs, move_all_that_a_library_wrote) {
  const TemporaryFolder folder;
  folder.write("cells.dbf", "old");
  Outputs outputs(replacing);
  const std::string path = outputs.add_foreign(folder.path("cells.shp"));
  EXPECT_EQ(std::filesystem::path(path).filename(), "cells.shp");
  std::ofstream(path) << "shapes";
  std::ofstream(std::filesystem::path(path).replace_extension("dbf")) << "table";
  outputs.commit();
  EXPECT_EQ(folder.names(), (Names{"cells.dbf", "cells.shp"}));
  EXPECT_EQ(folder.read("cells.shp"), "shapes");
  EXPECT_EQ(folder.read("cells.dbf"), "table");
}

TEST(Outputs, replace_no_side_file_unless_told_to) {
  const TemporaryFolder folder;
  folder.write("cells.dbf", "old");
  {
    Outputs outputs({});
    const std::string path = outputs.add_foreign(folder.path("cells.shp"));
    std::ofstream(path) << "shapes";
    std::ofstream(std::filesystem::path(path).replace_extension("dbf")) << "table";
    EXPECT_EQ(sentence_of([&] { outputs.commit(); }), folder.path("cells.dbf") + " exists already");
  }
  EXPECT_EQ(folder.names(), (Names{"cells.dbf"}));
  EXPECT_EQ(folder.read("cells.dbf"), "old");
}

TEST(Outputs, fail_where_a_library_wrote_nothing) {
  const TemporaryFolder folder;
  Outputs outputs({});
  outputs.add_foreign(folder.path("cells.shp"));
  EXPECT_EQ(sentence_of([&] { outputs.commit(); }),
            folder.path("cells.shp") + ": cannot write: No such file or directory");
}

TEST(Outputs, fail_whole_at_every_byte_where_the_disk_is_full) {
  const TemporaryFolder folder;
  folder.write("a.csv", "old");
  const auto attempt = [&](rlim_t bytes) {
    watch_for_interrupts();
    const rlimit limit = {bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const bool failed = sentence_of([&] {
                          Outputs outputs(replacing);
                          outputs.add(folder.path("a.csv")).append("0123456789");
                          outputs.add(folder.path("b.csv")).append("01234567890123456789");
                          outputs.commit();
                        }) != "no error";
    ::_exit(failed ? 1 : 0);
  };
  for (rlim_t bytes = 0; bytes < 20; ++bytes) {
    ASSERT_EXIT(attempt(bytes), ::testing::ExitedWithCode(1), "");
    ASSERT_EQ(folder.names(), (Names{"a.csv"}));
    ASSERT_EQ(folder.read("a.csv"), "old");
  }
  ASSERT_EXIT(attempt(20), ::testing::ExitedWithCode(0), "");
  EXPECT_EQ(folder.read("a.csv"), "0123456789");
}

TEST(Outputs, vanish_when_the_run_is_interrupted) {
  const TemporaryFolder folder;
  watch_for_interrupts();
  try {
    Outputs outputs({});
    outputs.add(folder.path("a.csv")).append("x");
    std::raise(SIGTERM);
    outputs.commit();
    FAIL();
  } catch (const Interrupted& interrupted) {
    EXPECT_EQ(interrupted.exit_status(), 143);
  }
  forget_interrupt();
  EXPECT_TRUE(folder.names().empty());
}

TEST(Outputs, make_the_folders_above_a_folder_too_and_take_all_of_them_back) {
  const TemporaryFolder folder;
  const std::string path = folder.path("a/b/c");
  { Outputs({}).make_folder(path); }
  EXPECT_TRUE(folder.names().empty());
  Outputs outputs({});
  outputs.make_folder(path + "/");
  outputs.add(path + "/x.csv").append("x");
  outputs.commit();
  EXPECT_EQ(folder.read("a/b/c/x.csv"), "x");
}

TEST(Outputs, make_a_folder_that_stays_only_if_all_goes_well) {
  const TemporaryFolder folder;
  const std::string path = folder.path("out");
  {
    Outputs outputs({});
    outputs.make_folder(path);
    outputs.add(path + "/a.csv").append("x");
  }
  EXPECT_TRUE(folder.names().empty());
  Outputs outputs({});
  outputs.make_folder(path);
  outputs.make_folder(path);
  outputs.add(path + "/a.csv").append("x");
  outputs.commit();
  EXPECT_EQ(folder.read("out/a.csv"), "x");
  const std::string file = folder.write("file", "");
  EXPECT_EQ(sentence_of([&] { Outputs({}).make_folder(file); }),
            file + ": cannot use the folder: Not a directory");
}

TEST(Outputs, replace_their_file_at_once_for_those_who_read_it) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.csv", std::string(100'000, '0'));
  const pid_t writer = ::fork();
  if (writer == 0) {
    for (int i = 0; i < 100; ++i) {
      Outputs outputs(replacing);
      outputs.add(path).append(std::string(100'000, static_cast<char>('0' + i % 10)));
      outputs.commit();
    }
    ::_exit(0);
  }
  for (int status = 0; ::waitpid(writer, &status, WNOHANG) == 0;) {
    const std::string text = folder.read("a.csv");
    ASSERT_EQ(text.size(), 100'000u);
    ASSERT_EQ(text.find_first_not_of(text[0]), std::string::npos);
  }
}

}  // namespace
}  // namespace thiessen
