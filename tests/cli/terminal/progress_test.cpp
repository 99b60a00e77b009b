#include "cli/terminal/progress.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <regex>
#include <string>
#include <thread>

#include "base/descriptor.h"

namespace thiessen::cli {
namespace {

/// Has a terminal for the standard error as long as it lives.
class OnTerminal {
 public:
  OnTerminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)), before_(::dup(STDERR_FILENO)) {
    EXPECT_EQ(::grantpt(master_.number()), 0);
    EXPECT_EQ(::unlockpt(master_.number()), 0);
    terminal_ = Descriptor(::open(::ptsname(master_.number()), O_RDWR | O_NOCTTY));
    EXPECT_EQ(::dup2(terminal_.number(), STDERR_FILENO), STDERR_FILENO);
    ::fcntl(master_.number(), F_SETFL, O_NONBLOCK);
  }
  ~OnTerminal() { ::dup2(before_.number(), STDERR_FILENO); }
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;

  /// What was shown since this was asked last.
  std::string shown() {
    std::string text;
    std::array<char, 1000> bytes{};
    for (ssize_t count = 0; (count = ::read(master_.number(), bytes.data(), bytes.size())) > 0;)
      text.append(bytes.data(), static_cast<std::size_t>(count));
    return text;
  }

 private:
  Descriptor master_;
  Descriptor before_;
  Descriptor terminal_;
};

Progress::Share done_is(double share) {
  return [share](std::size_t) { return share; };
}

void wait_until_it_speaks() {
  std::this_thread::sleep_for(std::chrono::milliseconds(1'050));
}

/// The line between what returns to its beginning and what clears the rest of it.
std::string line_in(const std::string& shown) {
  const std::string end = "\x1b[K";
  EXPECT_TRUE(shown.starts_with('\r') && shown.ends_with(end)) << shown;
  return shown.size() < 4 ? shown : shown.substr(1, shown.size() - 1 - end.size());
}

// All are made first, so that they wait for the second together.
TEST(Progress, says_how_much_is_done_and_how_long_the_rest_will_take) {
  OnTerminal terminal;
  Progress unknown("time step", false, done_is(std::nan("")));
  Progress one("time step", false, done_is(0));
  Progress half("time step", false, done_is(0.5));
  Progress small("time step", false, done_is(1. / 300));
  Progress tiny("time step", false, done_is(1e-4));
  Progress all("time step", false, done_is(1));
  wait_until_it_speaks();
  unknown.advance(1'234'567);
  EXPECT_EQ(line_in(terminal.shown()), "thiessen: 1,234,567 time steps");
  one.advance();
  EXPECT_EQ(line_in(terminal.shown()), "thiessen: 1 time step");
  // The rest takes as long as what has passed: a second and a little more.
  half.advance(999);
  const std::string seconds = line_in(terminal.shown());
  EXPECT_TRUE(std::regex_match(seconds, std::regex("thiessen: 999 time steps, 50 %, [2-9] s left")))
      << seconds;
  // 299 times as long, and 9,999 times.
  small.advance(1'000);
  const std::string minutes = line_in(terminal.shown());
  EXPECT_TRUE(std::regex_match(minutes, std::regex("thiessen: 1,000 time steps, 0 %, "
                                                   "([6-9]|[1-5][0-9]) min left")))
      << minutes;
  tiny.advance(12'345);
  const std::string hours = line_in(terminal.shown());
  EXPECT_TRUE(std::regex_match(hours, std::regex("thiessen: 12,345 time steps, 0 %, "
                                                 "([2-9]|[1-9][0-9]) h [1-5]?[0-9] min left")))
      << hours;
  all.advance(2);
  EXPECT_EQ(line_in(terminal.shown()), "thiessen: 2 time steps, 100 %");
}

TEST(Progress, is_silent_at_first_and_clears_its_line_in_the_end) {
  OnTerminal terminal;
  {
    Progress progress("time step", false, done_is(0.5));
    progress.advance();
    EXPECT_EQ(terminal.shown(), "") << "most tasks are done by then";
    wait_until_it_speaks();
    progress.advance();
    EXPECT_NE(terminal.shown(), "");
    progress.advance();
    EXPECT_EQ(terminal.shown(), "") << "it says something new a few times a second";
  }
  EXPECT_EQ(terminal.shown(), "\r\x1b[K");
  { Progress progress("time step", false, done_is(0.5)); }
  EXPECT_EQ(terminal.shown(), "") << "there is nothing to clear";
}

TEST(Progress, is_silent_where_it_is_to_be_quiet_and_in_a_pipe) {
  OnTerminal terminal;
  Progress quiet("time step", true, done_is(0.5));
  testing::internal::CaptureStderr();
  Progress piped("time step", false, done_is(0.5));
  wait_until_it_speaks();
  quiet.advance();
  piped.advance();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  quiet.advance();
  EXPECT_EQ(terminal.shown(), "");
}

}  // namespace
}  // namespace thiessen::cli
