#pragma once

#include <exception>

namespace thiessen {

/// The user or the system asked the program to stop. This is not an Error: nothing is wrong with
/// the input.
class Interrupted : public std::exception {
 public:
  explicit Interrupted(int signal) : signal_(signal) {}
  int signal() const { return signal_; }
  /// The exit status that a shell expects of a program ended by this signal: 130 for SIGINT, 143
  /// for SIGTERM.
  int exit_status() const { return 128 + signal_; }
  const char* what() const noexcept override { return "interrupted"; }

 private:
  int signal_;
};

/// Makes SIGINT, SIGTERM and SIGHUP from now on only leave a note, which `throw_if_interrupted`
/// reads, so that the stack unwinds and temporary files are removed. A signal that was ignored
/// (nohup) stays ignored. SIGPIPE and SIGXFSZ are ignored, because the write that caused them then
/// fails and says so.
void watch_for_interrupts();

/// The number of the signal that has come since the last `forget_interrupt`, or 0 if none has.
/// Cost: one load.
int interrupt_signal() noexcept;

/// Throws Interrupted if a signal has come. Long loops call it every so often, from any thread.
void throw_if_interrupted();

/// Leaves the note that SIGINT would leave, for a caller that hears of Ctrl-C by other ways. From
/// any thread.
void ask_to_stop() noexcept;

/// Forgets the signal that has come.
void forget_interrupt() noexcept;

/// Forgets Ctrl-C, for an interactive session that goes on after it. Returns false where no signal
/// has come, or one that ends the session.
bool forget_ctrl_c() noexcept;

}  // namespace thiessen
