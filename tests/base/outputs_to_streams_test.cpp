#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <string>

#include "base/outputs.h"
#include "base/sentence_of.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

TEST(Outputs, go_to_devices_and_pipes) {
  Outputs outputs({});
  outputs.add("/dev/null").append("x");
  EXPECT_NO_THROW(outputs.commit());
  struct stat status = {};
  ASSERT_EQ(::stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));

  Outputs full({});
  full.add("/dev/full").append("x");
  EXPECT_EQ(sentence_of([&] { full.commit(); }),
            "/dev/full: cannot write: No space left on device");

  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  Outputs piped({});
  piped.add("/dev/fd/" + std::to_string(ends[1])).append("through");
  piped.commit();
  char text[10] = {};
  EXPECT_EQ(::read(ends[0], text, sizeof text), 7);
  EXPECT_STREQ(text, "through");
  ::close(ends[0]);
  ::close(ends[1]);
  EXPECT_NE(sentence_of([] { Outputs({}).add_foreign("/dev/null"); }), "no error");
}

/// The bytes that wait in a pipe whose writing end is not blocking.
std::string drained(int end) {
  std::string all;
  std::array<char, 65'536> piece = {};
  for (ssize_t count = 0; (count = ::read(end, piece.data(), piece.size())) > 0;) {
    all.append(piece.data(), static_cast<std::size_t>(count));
  }
  return all;
}

TEST(Outputs, print_nothing_unless_committed) {
  for (const std::size_t bytes : {std::size_t{10}, std::size_t{1'000'000}}) {
    int ends[2] = {};
    ASSERT_EQ(::pipe2(ends, O_NONBLOCK), 0);
    const std::string path = "/dev/fd/" + std::to_string(ends[1]);
    {
      Outputs outputs({});
      OutputFile& file = outputs.add(path);
      for (std::size_t i = 0; i < bytes; ++i) file.append("x");
      file.flush();
    }
    ::close(ends[1]);
    EXPECT_EQ(drained(ends[0]), "");
    ::close(ends[0]);
  }
}

TEST(Outputs, print_what_no_buffer_holds_whole_and_in_order) {
  std::string expected;
  for (int i = 0; expected.size() < 3'000'000; ++i) expected += std::to_string(i) + ",";
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t writer = ::fork();
  if (writer == 0) {
    Outputs outputs({});
    OutputFile& file = outputs.add("/dev/fd/" + std::to_string(ends[1]));
    file.append(expected.substr(0, 10));
    file.append(expected.substr(10, 2'000'000));
    for (const char c : expected.substr(2'000'010)) file.append({&c, 1});
    outputs.commit();
    ::_exit(0);
  }
  ::close(ends[1]);
  EXPECT_EQ(drained(ends[0]), expected);
  ::close(ends[0]);
  ::waitpid(writer, nullptr, 0);
}

TEST(Outputs, are_printed_only_after_every_file_is_safe) {
  const TemporaryFolder folder;
  int ends[2] = {};
  ASSERT_EQ(::pipe2(ends, O_NONBLOCK), 0);
  {
    Outputs outputs({});
    outputs.add("/dev/fd/" + std::to_string(ends[1])).append("printed");
    outputs.add(folder.path("a.csv")).append("ours");
    folder.write("a.csv", "theirs");
    EXPECT_EQ(sentence_of([&] { outputs.commit(); }), folder.path("a.csv") + " exists already");
  }
  ::close(ends[1]);
  EXPECT_EQ(drained(ends[0]), "");
  ::close(ends[0]);
}

TEST(Outputs, are_not_renamed_where_a_device_fails) {
  const TemporaryFolder folder;
  Outputs outputs({});
  outputs.add(folder.path("a.csv")).append("x");
  outputs.add("/dev/full").append("x");
  EXPECT_EQ(sentence_of([&] { outputs.commit(); }),
            "/dev/full: cannot write: No space left on device");
  EXPECT_FALSE(folder.names().contains("a.csv"));
}

}  // namespace
}  // namespace thiessen
