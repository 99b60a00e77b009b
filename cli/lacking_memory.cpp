#include "cli/lacking_memory.h"

#include <sys/resource.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <execinfo.h>
#include <malloc.h>
#endif

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "base/last_words.h"
#include "base/memory.h"
#include "base/outputs.h"
#include "cli/terminal/messages.h"
#include "gdal/gdal_errors.h"
#include "map/opencv/fonts.h"

namespace thiessen::cli {
namespace {

constexpr int failed = 1;  // the exit status

/// Where nothing else is left to do. What has no name vanishes with the process.
[[noreturn]] void end_without_memory() noexcept {
  Outputs::abandon_all();
  print_lack_of_memory();
  ::_exit(failed);
}

/// What the C++ library does about an exception that nothing caught: it says which, and aborts.
std::terminate_handler end_of_library = nullptr;

/// A library that throws for want of memory where nothing may be thrown calls this.
[[noreturn]] void end_after_uncaught() noexcept {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (...) {  // the library's own end, below, tells of it
  }
  if (end_of_library != nullptr) end_of_library();
  std::abort();
}

/// Called wherever C++ finds no memory, in libraries too, which may catch what is thrown.
[[noreturn]] void note_and_throw() {
  note_lack_of_memory();
  throw std::bad_alloc();
}

/// The C library loads what it needs to end a thread when it is first needed, and gives up where
/// there is no memory for it then.
void load_unwinder() noexcept {
#ifdef __GLIBC__
  void* frame = nullptr;
  ::backtrace(&frame, 1);
#endif
}

/// Each thread would have 64 MB of addresses of its own, which then lack where they are counted.
void share_what_is_limited() noexcept {
#ifdef __GLIBC__
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    ::mallopt(M_ARENA_MAX, 1);
#endif
}

extern "C" {
/// Libraries in C break off where they were given no memory and did not ask.
static void end_after_break(int signal) {
  if (memory_is_short()) end_without_memory();
  Outputs::abandon_all();
  if (const std::string_view words = last_words(); !words.empty()) {
    print_last_words(words);
    ::_exit(failed);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}
}

/// Has a signal that would end the program do so in our way, unless another part of the process
/// hears it.
void note_break(int signal) noexcept {
  struct sigaction old = {};
  if (::sigaction(signal, nullptr, &old) != 0 || old.sa_handler != SIG_DFL) return;
  struct sigaction action = {};
  action.sa_handler = end_after_break;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  ::sigaction(signal, &action, nullptr);
}

/// A stack that is used up has no room for what hears of it.
void have_another_stack() noexcept {
  alignas(std::max_align_t) static char room[std::size_t{64} << 10];
  stack_t stack = {};
  stack.ss_sp = room;
  stack.ss_size = sizeof room;
  ::sigaltstack(&stack, nullptr);
}

}  // namespace

void watch_for_uncaught() noexcept {
  const std::terminate_handler before = std::set_terminate(end_after_uncaught);
  if (before != end_after_uncaught) end_of_library = before;
}

void watch_for_lack_of_memory() noexcept {
  forget_lack_of_memory();
  note_last_words({});
  share_what_is_limited();
  watch_for_uncaught();
  std::set_new_handler(note_and_throw);
  load_unwinder();
  when_gdal_lacks_memory(end_without_memory);
  when_fonts_break_off(end_without_memory);
#ifndef __SANITIZE_ADDRESS__
  have_another_stack();
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT}) note_break(signal);
#endif
}

bool memory_is_short() noexcept {
  constexpr std::size_t little = std::size_t{16} << 20;
  return has_lacked_memory() || !can_have(little);
}

}  // namespace thiessen::cli
