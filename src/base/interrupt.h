#pragma once

#include <exception>

namespace thiessen {

/// The user, or the system, asked the program to stop. Not an Error: nothing is wrong with the
/// input.
class Interrupted : public std::exception {
 public:
  explicit Interrupted(int signal) : signal_(signal) {}
  int signal() const { return signal_; }
  /// What a shell expects of a program ended by that signal: 130 for SIGINT, 143 for SIGTERM.
  int exit_status() const { return 128 + signal_; }
  const char* what() const noexcept override { return "interrupted"; }

 private:
  int signal_;
};

/// From now on SIGINT, SIGTERM and SIGHUP only leave a note, read by `throw_if_interrupted`, so
/// that the stack unwinds and temporary files go; one that was ignored (nohup) stays ignored.
/// SIGPIPE and SIGXFSZ are ignored: the write that caused them fails, and says so.
void watch_for_interrupts();

/// Whether a signal has come since the last `forget_interrupt`; its number, else 0. Costs one load.
int interrupt_signal() noexcept;

/// Throws Interrupted if a signal has come. Loops that may last call it every so often, from any
/// thread.
void throw_if_interrupted();

/// Makes as if no signal had come, for an interactive session that goes on after Ctrl-C.
void forget_interrupt() noexcept;

}  // namespace thiessen
