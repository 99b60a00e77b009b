#include "cli/lacking_memory.h"
#include "cli/program.h"

namespace {

/// Libraries take memory before main begins, and throw where there is none.
extern "C" void watch_for_lack_of_memory(int, char**, char**) {
  thiessen::cli::watch_for_uncaught();
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
// The system calls this before any library's own beginning.
[[gnu::section(".preinit_array"),
  gnu::used]] void (*const before_libraries)(int, char**, char**) = watch_for_lack_of_memory;
#endif

}  // namespace

int main(int argc, char** argv) {
  return thiessen::cli::run_program(argc, argv);
}
