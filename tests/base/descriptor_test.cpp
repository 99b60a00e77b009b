#include "base/descriptor.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

bool is_open(int number) {
  return ::fcntl(number, F_GETFD) >= 0;
}

Descriptor nothing() {
  return Descriptor(::open("/dev/null", O_RDWR | O_CLOEXEC));
}

/// What a child process returns, which begins without these streams.
int without(const std::vector<int>& streams, const std::function<int()>& act) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int stream : streams) ::close(stream);
    hold_standard_streams();
    ::_exit(act());
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WEXITSTATUS(status);
}

TEST(Descriptor, is_closed_with_its_owner) {
  int number = -1;
  {
    const Descriptor owner = nothing();
    number = owner.number();
    EXPECT_TRUE(owner.is_open());
    EXPECT_TRUE(is_open(number));
  }
  EXPECT_FALSE(is_open(number));
  EXPECT_FALSE(Descriptor().is_open());
}

TEST(Descriptor, law_1_has_one_owner_however_it_is_handed_on) {
  Descriptor first = nothing();
  const int number = first.number();
  Descriptor second(std::move(first));
  EXPECT_FALSE(first.is_open());  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(second.number(), number);
  Descriptor third = nothing();
  const int replaced = third.number();
  third = std::move(second);
  EXPECT_EQ(third.number(), number);
  EXPECT_FALSE(is_open(replaced)) << "nobody owns it any more";
  Descriptor& itself = third;
  third = std::move(itself);
  EXPECT_EQ(third.number(), number);
  EXPECT_TRUE(is_open(number));
}

TEST(Descriptor, law_2_is_closed_once) {
  Descriptor owner = nothing();
  const int number = owner.number();
  EXPECT_TRUE(owner.close());
  EXPECT_FALSE(is_open(number));
  const Descriptor other = nothing();
  ASSERT_EQ(other.number(), number) << "the lowest that is free";
  EXPECT_TRUE(owner.close()) << "there is nothing to close";
  EXPECT_TRUE(is_open(number));
}

TEST(Descriptor, tells_that_closing_failed) {
  Descriptor owner = nothing();
  ::close(owner.number());
  EXPECT_FALSE(owner.close());
  EXPECT_EQ(errno, EBADF);
}

TEST(Descriptor, handed_over_is_left_to_its_new_owner_to_close) {
  int number = -1;
  {
    Descriptor owner = nothing();
    number = owner.release();
    EXPECT_FALSE(owner.is_open());
  }
  EXPECT_TRUE(is_open(number));
  const Descriptor closed(number);
}

TEST(Descriptor, law_3_a_twin_is_of_the_same_open_file_and_outlives_the_first) {
  const TemporaryFolder folder;
  Descriptor first = open_descriptor(folder.path("a"), O_RDWR | O_CREAT, 0600);
  const Descriptor twin = first.twin("a");
  EXPECT_NE(twin.number(), first.number());
  EXPECT_EQ(::write(first.number(), "abc", 3), 3);
  EXPECT_EQ(::lseek(twin.number(), 0, SEEK_CUR), 3) << "they write on from one place";
  EXPECT_TRUE(first.close());
  EXPECT_EQ(::write(twin.number(), "d", 1), 1);
}

TEST(Descriptor, law_4_a_twin_takes_no_standard_streams_place_and_is_not_passed_on) {
  const int closed_error = without({STDERR_FILENO}, [] {
    ::close(STDERR_FILENO);  // which was held
    return twin_of(STDOUT_FILENO).number();
  });
  EXPECT_GT(closed_error, STDERR_FILENO);
  const Descriptor twin = nothing().twin("a");
  EXPECT_EQ(::fcntl(twin.number(), F_GETFD) & FD_CLOEXEC, FD_CLOEXEC);
}

TEST(Descriptor, of_none_has_no_twin) {
  errno = 0;
  EXPECT_FALSE(twin_of(-1).is_open());
  EXPECT_EQ(errno, EBADF);
  EXPECT_EQ(complaint_of([] { Descriptor().twin("a.csv"); }),
            "a.csv: cannot write: Bad file descriptor");
}

TEST(Descriptor, of_a_file_is_not_passed_on_to_other_programs) {
  const TemporaryFolder folder;
  const Descriptor made = open_descriptor(folder.path("a"), O_WRONLY | O_CREAT, 0600);
  ASSERT_TRUE(made.is_open());
  EXPECT_EQ(::fcntl(made.number(), F_GETFD) & FD_CLOEXEC, FD_CLOEXEC);
  EXPECT_EQ(folder.names(), std::set<std::string>{"a"});
}

TEST(Descriptor, of_a_file_that_cannot_be_opened_is_not_open_and_errno_tells_why) {
  const TemporaryFolder folder;
  EXPECT_FALSE(open_descriptor(folder.path("no"), O_RDONLY).is_open());
  EXPECT_EQ(errno, ENOENT);
  EXPECT_FALSE(open_descriptor(folder.path(), O_WRONLY).is_open());
  EXPECT_EQ(errno, EISDIR);
}

TEST(Descriptor, a_call_that_failed_is_told_in_the_systems_words) {
  EXPECT_STREQ(system_error("a.csv", "cannot open", ENOENT).what(),
               "a.csv: cannot open: No such file or directory");
}

// Else the first file would be the standard output, and whatever is printed would go into it.
TEST(StandardStreams, law_1_no_file_takes_the_number_of_one_that_is_closed) {
  const auto first_file = [] { return ::open("/dev/null", O_RDONLY); };
  for (const auto& streams : std::vector<std::vector<int>>{{0}, {1}, {2}, {0, 1, 2}, {0, 2}})
    EXPECT_GT(without(streams, first_file), 2);
}

TEST(StandardStreams, law_2_reading_or_writing_one_that_is_closed_fails_as_before) {
  EXPECT_EQ(without({0},
                    [] {
                      char byte = 0;
                      return ::read(0, &byte, 1) < 0 ? errno : 0;
                    }),
            EBADF);
  EXPECT_EQ(without({1}, [] { return ::write(1, "a", 1) < 0 ? errno : 0; }), EBADF);
  EXPECT_EQ(without({2}, [] { return ::write(2, "a", 1) < 0 ? errno : 0; }), EBADF);
}

TEST(StandardStreams, law_3_one_that_is_open_is_left_as_it_is) {
  EXPECT_EQ(without({0}, [] { return ::fcntl(1, F_GETFL) & O_ACCMODE; }),
            ::fcntl(1, F_GETFL) & O_ACCMODE);
}

}  // namespace
}  // namespace thiessen
