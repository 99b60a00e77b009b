// What may be written, by what stands at the name.
#include "base/destination.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Kind = Destination::Kind;

Kind kind_of(const std::string& path, const OutputRules& rules = {true, {}}) {
  return examine_destination(path, rules).kind;
}

bool is_refused(const std::string& path, const OutputRules& rules) {
  return !complaints_of([&] { examine_destination(path, rules); }).empty();
}

TEST(Destination, law_1_is_told_by_what_stands_there_through_links) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "text");
  std::filesystem::create_symlink(file, folder.path("link"));
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(kind_of(folder.path("nothing")), Kind::nothing);
  EXPECT_EQ(kind_of(file), Kind::file);
  EXPECT_EQ(kind_of(folder.path("link")), Kind::link);
  EXPECT_EQ(kind_of(folder.path("pipe")), Kind::stream);
  EXPECT_EQ(kind_of("/dev/null"), Kind::stream);
  EXPECT_EQ(examine_destination(folder.path("link"), {true, {}}).status.st_size, 4);
}

TEST(Destination, law_2_what_exists_is_replaced_only_where_that_is_allowed) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "text");
  EXPECT_TRUE(is_refused(file, {false, {}}));
  EXPECT_EQ(kind_of(file, {true, {}}), Kind::file);
  EXPECT_EQ(kind_of("/dev/null", {false, {}}), Kind::stream);
  EXPECT_EQ(kind_of(folder.path("nothing"), {false, {}}), Kind::nothing);
}

TEST(Destination, law_3_an_input_is_never_replaced_whatever_it_is_called) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "text");
  std::filesystem::create_hard_link(file, folder.path("other"));
  std::filesystem::create_symlink(file, folder.path("link"));
  for (const char* name : {"file", "other", "link"})
    EXPECT_TRUE(is_refused(folder.path(name), {true, {"not there", file}})) << name;
  EXPECT_EQ(kind_of(folder.write("apart", "text"), {true, {"not there", file}}), Kind::file);
}

TEST(Destination, law_4_what_cannot_become_a_file_is_refused) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink(folder.path("nowhere"), folder.path("dangling"));
  for (const std::string& path : {std::string(), folder.path(), folder.path() + "/",
                                  folder.path("new/"), folder.path("dangling")})
    EXPECT_TRUE(is_refused(path, {true, {}})) << path;
}

TEST(Destination, law_5_a_name_is_its_folder_and_its_name_in_it) {
  for (const char* path : {"a/b.csv", "/b.csv", "b.csv", "../x/y/b.csv"}) {
    EXPECT_EQ(name_in_folder(path), "b.csv");
    EXPECT_EQ((std::filesystem::path(folder_of(path)) / "b.csv").lexically_normal(),
              std::filesystem::path(path).lexically_normal());
  }
  EXPECT_EQ(folder_of("b.csv"), ".");
  EXPECT_EQ(folder_of("/b.csv"), "/");
}

TEST(Destination, law_6_standing_names_are_descriptors_and_no_others_are) {
  EXPECT_EQ(standing_descriptor("/dev/stdin"), STDIN_FILENO);
  EXPECT_EQ(standing_descriptor("/dev/stdout"), STDOUT_FILENO);
  EXPECT_EQ(standing_descriptor("/dev/stderr"), STDERR_FILENO);
  EXPECT_EQ(standing_descriptor("/dev/fd/3"), 3);
  EXPECT_EQ(standing_descriptor("/proc/self/fd/12"), 12);
  for (const char* path : {"/dev/fd/", "/dev/fd/x", "/dev/fd/-1", "/dev/fd/99999999", "/dev/null",
                           "stdout", "x/dev/stdout"})
    EXPECT_EQ(standing_descriptor(path), std::nullopt) << path;
}

TEST(Destination, law_7_fresh_names_are_hidden_in_the_folder_and_never_the_same) {
  const std::string one = fresh_name("some/folder");
  EXPECT_EQ(folder_of(one), "some/folder");
  EXPECT_EQ(name_in_folder(one).front(), '.');
  EXPECT_NE(one, fresh_name("some/folder"));
}

}  // namespace
}  // namespace thiessen
