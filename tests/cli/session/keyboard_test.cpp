#include "cli/session/keyboard.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/descriptor.h"
#include "base/interrupt.h"

namespace thiessen::cli {
namespace {

using Lines = std::vector<std::string>;

/// Has a terminal for the standard input and output as long as it lives, and somebody who types on
/// it. Between two lines the terminal has an editing of its own, so that the keys of each line come
/// only when the line before is read and the keyboard asks for keys.
class Typist {
 public:
  explicit Typist(Lines lines) : lines_(std::move(lines)) {
    ::grantpt(master_.number());
    ::unlockpt(master_.number());
    terminal_ = Descriptor(::open(::ptsname(master_.number()), O_RDWR | O_NOCTTY));
    ::setenv("TERM", "xterm", 1);
    ::setenv("LC_ALL", "C.UTF-8", 1);
    std::fflush(stdout);
    ::dup2(terminal_.number(), STDIN_FILENO);
    ::dup2(terminal_.number(), STDOUT_FILENO);
    typing_ = std::thread([this] { type(); });
  }
  ~Typist() {
    has_left_ = true;
    typing_.join();
    std::fflush(stdout);
    ::dup2(input_.number(), STDIN_FILENO);
    ::dup2(output_.number(), STDOUT_FILENO);
    std::setlocale(LC_CTYPE, locale_.c_str());
    if (all_) {
      ::setenv("LC_ALL", all_->c_str(), 1);
    } else {
      ::unsetenv("LC_ALL");
    }
  }
  Typist(const Typist&) = delete;
  Typist& operator=(const Typist&) = delete;

  /// Says that a line was read.
  void has_read() { ++lines_read_; }

 private:
  static std::optional<std::string> variable(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
  }
  bool is_asked() const {
    termios modes{};
    return ::tcgetattr(master_.number(), &modes) == 0 && (modes.c_lflag & ICANON) == 0;
  }
  void type() {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      while (!has_left_ && (lines_read_ < i || !is_asked()))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (has_left_) return;
      const auto size = static_cast<ssize_t>(lines_[i].size());
      EXPECT_EQ(::write(master_.number(), lines_[i].data(), lines_[i].size()), size);
    }
  }

  Lines lines_;
  Descriptor master_{::posix_openpt(O_RDWR | O_NOCTTY)};
  Descriptor terminal_;
  Descriptor input_{::dup(STDIN_FILENO)};
  Descriptor output_{::dup(STDOUT_FILENO)};
  std::string locale_{std::setlocale(LC_CTYPE, nullptr)};
  std::optional<std::string> all_ = variable("LC_ALL");
  std::atomic<std::size_t> lines_read_ = 0;
  std::atomic<bool> has_left_ = false;
  std::thread typing_;
};

constexpr const char* end = "\x04";  // Ctrl-D
constexpr const char* up = "\x1b[A";

/// The lines that a keyboard reads of these keys, a line each, to the end of its input.
Lines lines_of(Lines keys) {
  for (std::string& line : keys) line += '\r';
  keys.emplace_back(end);
  Typist typist(std::move(keys));
  Keyboard keyboard({"insert", "inspect", "delete"});
  Lines lines;
  while (const auto line = keyboard.next()) {
    lines.push_back(*line);
    typist.has_read();
  }
  return lines;
}

TEST(Keyboard, reads_lines_to_the_end_of_the_input) {
  EXPECT_EQ(lines_of({"insert 1 2", "delete 1"}), (Lines{"insert 1 2", "delete 1"}));
  EXPECT_EQ(lines_of({}), Lines{});
  EXPECT_EQ(lines_of({"", "a"}), (Lines{"", "a"}));
}

TEST(Keyboard, lets_a_line_be_edited) {
  EXPECT_EQ(lines_of({"ab\x7f"
                      "c"}),
            Lines{"ac"})
      << "backspace";
  EXPECT_EQ(lines_of({"bc\x01"
                      "a"}),
            Lines{"abc"})
      << "Ctrl-A goes to its beginning";
}

TEST(Keyboard, reads_letters_of_several_bytes) {
  EXPECT_EQ(lines_of({"load Zürich雨.csv"}), Lines{"load Zürich雨.csv"});
  EXPECT_EQ(lines_of({"aü\x7f"
                      "b"}),
            Lines{"ab"})
      << "backspace takes the letter away, not a byte";
}

TEST(Keyboard, passes_over_bytes_that_are_no_letter) {
  EXPECT_EQ(lines_of({"a\xFF"
                      "b"}),
            Lines{"ab"});
}

TEST(Keyboard, completes_a_command_by_the_tab_key) {
  EXPECT_EQ(lines_of({"d\t3"}), Lines{"delete 3"});
  EXPECT_EQ(lines_of({"inse\t1 2"}), Lines{"insert 1 2"});
  EXPECT_EQ(lines_of({"delete\t3"}), Lines{"delete 3"}) << "the blank alone";
}

TEST(Keyboard, completes_what_all_that_fit_have_in_common_and_chooses_none) {
  EXPECT_EQ(lines_of({"i\tp\t7"}), Lines{"inspect 7"}) << "i, ins, insp, inspect";
  EXPECT_EQ(lines_of({"ins\t\t"}), Lines{"ins"});
}

TEST(Keyboard, completes_nothing_else) {
  EXPECT_EQ(lines_of({"x\t"}), Lines{"x"});
  EXPECT_EQ(lines_of({"delete d\t"}), Lines{"delete d"}) << "no second word";
  EXPECT_EQ(lines_of({"de3\x02\t"}), Lines{"de3"}) << "not in the midst of a line";
}

TEST(Keyboard, has_earlier_lines_by_the_arrow_key) {
  EXPECT_EQ(lines_of({"a", "b", up, std::string(up) + up}), (Lines{"a", "b", "b", "a"}))
      << "each once";
  EXPECT_EQ(lines_of({"a", "", up}), (Lines{"a", "", "a"})) << "an empty one is not remembered";
}

/// The first line that is read where a signal came before.
std::optional<std::string> line_after(int signal) {
  watch_for_interrupts();
  const Typist typist({"a\r"});
  Keyboard keyboard({});
  std::raise(signal);
  return keyboard.next();
}

TEST(Keyboard, goes_on_after_ctrl_c_and_ends_with_any_other_signal) {
  EXPECT_EQ(line_after(SIGINT), "a");
  EXPECT_EQ(interrupt_signal(), 0);
  for (const int signal : {SIGTERM, SIGHUP}) {
    EXPECT_THROW(line_after(signal), Interrupted);
    forget_interrupt();
  }
}

}  // namespace
}  // namespace thiessen::cli
