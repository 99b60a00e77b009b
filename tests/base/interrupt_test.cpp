#include "base/interrupt.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

namespace thiessen {
namespace {

class Interrupt : public ::testing::Test {
 protected:
  void SetUp() override { watch_for_interrupts(); }
  void TearDown() override { forget_interrupt(); }
};

TEST_F(Interrupt, is_noted_and_thrown_where_asked_for) {
  EXPECT_NO_THROW(throw_if_interrupted());
  std::raise(SIGINT);
  EXPECT_EQ(interrupt_signal(), SIGINT);
  EXPECT_THROW(throw_if_interrupted(), Interrupted);
  forget_interrupt();
  EXPECT_NO_THROW(throw_if_interrupted());
}

TEST_F(Interrupt, has_the_exit_status_that_shells_expect) {
  EXPECT_EQ(Interrupted(SIGINT).exit_status(), 130);
  EXPECT_EQ(Interrupted(SIGTERM).exit_status(), 143);
  EXPECT_EQ(Interrupted(SIGHUP).exit_status(), 129);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::raise(signal);
    try {
      throw_if_interrupted();
      FAIL();
    } catch (const Interrupted& interrupted) {
      EXPECT_EQ(interrupted.signal(), signal);
    }
  }
}

TEST_F(Interrupt, ctrl_c_alone_is_forgotten_as_such) {
  EXPECT_FALSE(forget_ctrl_c()) << "nothing has come";
  std::raise(SIGINT);
  EXPECT_TRUE(forget_ctrl_c());
  EXPECT_NO_THROW(throw_if_interrupted());
  std::raise(SIGTERM);
  EXPECT_FALSE(forget_ctrl_c());
  EXPECT_THROW(throw_if_interrupted(), Interrupted);
}

TEST_F(Interrupt, does_not_come_of_a_signal_that_was_ignored) {
  std::signal(SIGHUP, SIG_IGN);
  watch_for_interrupts();
  std::raise(SIGHUP);
  EXPECT_NO_THROW(throw_if_interrupted());
  std::signal(SIGHUP, SIG_DFL);
}

TEST_F(Interrupt, is_not_what_a_closed_pipe_causes) {
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  EXPECT_EQ(::write(ends[1], "x", 1), -1) << "and SIGPIPE does not end the program";
  EXPECT_NO_THROW(throw_if_interrupted());
  ::close(ends[1]);
}

}  // namespace
}  // namespace thiessen
