#include "cli/terminal/line_width.h"

#include <sys/ioctl.h>
#include <unistd.h>

namespace thiessen::cli {

std::size_t line_width() {
  constexpr std::size_t usual = 80;
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return size.ws_col;
}

}  // namespace thiessen::cli
