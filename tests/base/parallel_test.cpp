#include "base/parallel.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/interrupt.h"

namespace thiessen {
namespace {

TEST(InParallel, law_1_every_number_is_worked_at_once) {
  for (const unsigned threads : {0u, 1u, 2u, 7u}) {
    for (const std::size_t count : {0u, 1u, 5u, 1000u}) {
      std::vector<std::atomic<int>> times(count);
      in_parallel(count, threads, [&](std::size_t, std::size_t i) { ++times[i]; });
      for (const auto& t : times) EXPECT_EQ(t, 1);
    }
  }
}

TEST(InParallel, law_2_workers_are_numbered_below_the_threads_and_do_one_thing_at_a_time) {
  constexpr unsigned threads = 4;
  std::vector<std::atomic<int>> busy(threads);
  in_parallel(1000, threads, [&](std::size_t worker, std::size_t) {
    ASSERT_LT(worker, threads);
    EXPECT_EQ(++busy[worker], 1);
    --busy[worker];
  });
}

TEST(InParallel, law_3_of_what_is_thrown_one_exception_comes_out_when_all_have_stopped) {
  std::atomic<int> working{0};
  const auto work = [&](std::size_t, std::size_t i) {
    ++working;
    const std::string number = std::to_string(i);
    if (i % 10 == 7) {
      --working;
      throw std::runtime_error(number);
    }
    --working;
  };
  for (const unsigned threads : {1u, 4u}) {
    try {
      in_parallel(1000, threads, work);
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::stoi(error.what()) % 10, 7);
      EXPECT_EQ(working, 0);
    }
  }
}

TEST(InParallel, law_4_a_signal_stops_it) {
  watch_for_interrupts();
  std::atomic<std::size_t> done{0};
  EXPECT_THROW(in_parallel(1'000'000, 2,
                           [&](std::size_t, std::size_t i) {
                             if (i == 10) std::raise(SIGINT);
                             ++done;
                           }),
               Interrupted);
  EXPECT_LT(done, 1'000'000u);
  forget_interrupt();
}

/// Does two things side by side in every way, and ends with 0 where all is as it should be.
[[noreturn]] void do_side_by_side(bool has_threads) {
  if (!has_threads) {  // one that counts for no other user can start no thread
    rlimit one = {};
    one.rlim_cur = one.rlim_max = 1;
    if (::getuid() == 0 && ::setuid(65534) != 0) ::_exit(0);
    ::setrlimit(RLIMIT_NPROC, &one);
  }
  int done = 0;
  side_by_side([&] { done += 1; }, [] {});
  side_by_side([] {}, [&] { done += 2; });
  in_parallel(4, 4, [](std::size_t, std::size_t) {});
  if (can_start_threads(3) != has_threads || !can_start_threads(0)) done = 0;
  int thrown = 0;
  const auto fail = [] { throw std::runtime_error("it failed"); };
  try {
    side_by_side(fail, [] {});
  } catch (const std::runtime_error&) {
    ++thrown;
  }
  try {
    side_by_side([] {}, fail);
  } catch (const std::runtime_error&) {
    ++thrown;
  }
  ::_exit(done == 3 && thrown == 2 ? 0 : 1);
}

TEST(SideBySide, both_are_done_and_what_is_thrown_comes_out) {
  EXPECT_EXIT(do_side_by_side(true), ::testing::ExitedWithCode(0), "");
}

TEST(SideBySide, where_no_thread_can_be_had_all_is_done_on_this_one) {
  EXPECT_EXIT(do_side_by_side(false), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace thiessen
