#include "base/interrupt.h"

#include <csignal>

#include <atomic>

namespace thiessen {
namespace {

std::atomic<int> noted_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait");

// The name of a function of C is its whole name, in a namespace too: static keeps it from others.
extern "C" {
static void note_signal(int signal) {
  noted_signal.store(signal, std::memory_order_relaxed);
}
}

void note(int signal) {
  struct sigaction old = {};
  if (sigaction(signal, nullptr, &old) != 0 || old.sa_handler == SIG_IGN) return;
  struct sigaction action = {};
  action.sa_handler = note_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = 0;  // without SA_RESTART, so that a waiting read returns
  sigaction(signal, &action, nullptr);
}

}  // namespace

void watch_for_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) note(signal);
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

int interrupt_signal() noexcept {
  return noted_signal.load(std::memory_order_relaxed);
}

void throw_if_interrupted() {
  if (const int signal = interrupt_signal(); signal != 0) throw Interrupted(signal);
}

void ask_to_stop() noexcept {
  noted_signal.store(SIGINT, std::memory_order_relaxed);
}

void forget_interrupt() noexcept {
  noted_signal.store(0, std::memory_order_relaxed);
}

bool forget_ctrl_c() noexcept {
  int expected = SIGINT;
  return noted_signal.compare_exchange_strong(expected, 0, std::memory_order_relaxed);
}

}  // namespace thiessen
