#include "cli/program.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/interrupt.h"
#include "base/temporary_folder.h"
#include "cli/lacking_memory.h"

namespace thiessen::cli {
namespace {

/// A run of the program, and what it leaves behind.
struct Ended {
  explicit Ended(std::vector<std::string> words) {
    words.insert(words.begin(), "thiessen");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    status = run_program(static_cast<int>(words.size()), arguments.data());
    out = testing::internal::GetCapturedStdout();
    told = testing::internal::GetCapturedStderr();
  }

  int status;
  std::string out;
  std::string told;  ///< on the standard error
};

/// A study of two gauges in a basin, whose weights are 0.4 and 0.6.
struct Study {
  std::vector<std::string> weights(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"weights", stations, basins, "--metric", "planar"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  TemporaryFolder folder;
  std::string stations = folder.write("s.csv", "id,x,y\nA,0,2\nB,8,2\n");
  std::string basins = folder.write("b.csv", "id,WKT\nQ,\"POLYGON ((0 0,10 0,10 4,0 4,0 0))\"\n");
};

TEST(Program, ends_with_0_where_all_is_done) {
  const Study study;
  const Ended run(study.weights());
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(contains(run.out, "Q,A,16,0.4\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "Q,B,24,0.6\n")) << run.out;
}

TEST(Program, ends_with_0_where_only_the_version_or_the_help_is_asked_for) {
  const Ended version({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_TRUE(version.out.starts_with("thiessen ")) << version.out;
  EXPECT_EQ(version.told, "");
  const Ended help({"weights", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_TRUE(contains(help.out, "--metric"));
}

TEST(Program, ends_with_2_where_the_command_line_is_wrong_and_says_where_the_help_is) {
  const Ended none({});
  EXPECT_EQ(none.status, 2);
  EXPECT_EQ(none.out, "");
  EXPECT_TRUE(none.told.starts_with("thiessen: error: no command is given\nhint: ")) << none.told;
  const Ended unknown({"weights", "--metrik"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(unknown.told.starts_with("thiessen: error: unknown option '--metrik'\nhint: "));
}

TEST(Program, ends_with_1_where_the_input_is_wrong_and_names_every_fault) {
  const Study study;
  study.folder.write("s.csv", "id,x,y\nA,a,2\nB,8,b\n");
  const Ended run(study.weights());
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "") << "all or nothing";
  EXPECT_TRUE(contains(run.told, "thiessen: error: " + study.stations + ":2: ")) << run.told;
  EXPECT_TRUE(contains(run.told, "thiessen: error: " + study.stations + ":3: ")) << run.told;
}

TEST(Program, tells_notices_then_warnings_unless_it_is_to_be_quiet) {
  const Study study;
  const Ended run(study.weights());
  EXPECT_TRUE(contains(run.told, "thiessen: notice: ")) << run.told;
  const Ended quiet(study.weights({"-q"}));
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.told, "");
  EXPECT_EQ(quiet.out, run.out);
}

// What was odd about the stations may be why the basins do not fit them.
TEST(Program, tells_of_warnings_before_an_error_too) {
  const Study study;
  study.folder.write("s.csv", "id,x,y\nA,0,2\nA,0,2\nB,8,2\n");
  study.folder.write("b.csv", "id,WKT\nQ,nonsense\n");
  const Ended run(study.weights());
  EXPECT_EQ(run.status, 1);
  const std::size_t notice = run.told.find("thiessen: notice: ");
  const std::size_t error = run.told.find("thiessen: error: ");
  EXPECT_NE(notice, std::string::npos) << run.told;
  EXPECT_LT(notice, error) << run.told;
}

TEST(Program, ends_as_shells_expect_where_a_signal_came_and_says_what_was_written) {
  const Study study;
  watch_for_interrupts();
  for (const int signal : {SIGINT, SIGTERM}) {
    std::raise(signal);
    const Ended run(study.weights());
    forget_interrupt();
    EXPECT_EQ(run.status, 128 + signal);
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(contains(run.told, "thiessen: error: interrupted; nothing was written"))
        << run.told;
  }
}

void throw_as_a_library() {
  throw std::runtime_error("words of a library");
}

void throw_where_nothing_may_be_thrown() noexcept {
  watch_for_uncaught();
  watch_for_uncaught();  // as the program does: before its work, and in it
  throw_as_a_library();
}

TEST(ProgramDeathTest, tells_what_nothing_caught_before_it_aborts) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(throw_where_nothing_may_be_thrown(), testing::KilledBySignal(SIGABRT),
              "words of a library");
}

}  // namespace
}  // namespace thiessen::cli
