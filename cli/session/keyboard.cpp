#include "cli/session/keyboard.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <new>
#include <string_view>
#include <utility>

#include "base/interrupt.h"

namespace thiessen::cli {
namespace {

constexpr int lines_remembered = 1000;

/// The longest beginning that all of the words share.
std::string common_beginning(const std::vector<std::string>& words) {
  std::string common = words.front();
  for (const std::string& word : words) {
    const auto parting = std::mismatch(common.begin(), common.end(), word.begin(), word.end());
    common.erase(parting.first, common.end());
  }
  return common;
}

/// Waits until a key can be read. Returns false where a signal came first, even one just before the
/// wait.
bool wait_for_key() {
  sigset_t interrupts;
  sigset_t before;
  sigemptyset(&interrupts);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&interrupts, signal);
  pthread_sigmask(SIG_BLOCK, &interrupts, &before);
  pollfd keys{STDIN_FILENO, POLLIN, 0};
  // Signals are blocked but during the wait, so that none can slip in between the test and the
  // wait.
  while (interrupt_signal() == 0 && ::ppoll(&keys, 1, nullptr, &before) < 0 && errno == EINTR) {
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return interrupt_signal() == 0;
}

}  // namespace

Keyboard::Keyboard(std::vector<std::string> words) : words_(std::move(words)) {
  std::setlocale(LC_CTYPE, "");  // the encoding of the terminal's bytes
  FILE* const shown = isatty(STDOUT_FILENO) == 1 ? stdout : stderr;
  history_.reset(history_init());
  editor_.reset(el_init("thiessen", stdin, shown, stderr));
  if (!history_ || !editor_) throw std::bad_alloc();
  HistEvent event;
  history(history_.get(), &event, H_SETSIZE, lines_remembered);
  history(history_.get(), &event, H_SETUNIQUE, 1);
  EditLine* const editor = editor_.get();
  el_set(editor, EL_CLIENTDATA, this);
  el_set(editor, EL_HIST, history, history_.get());
  el_set(editor, EL_EDITOR, "emacs");
  el_set(
      editor, EL_PROMPT, +[](EditLine*) {
        static std::string prompt = "> ";
        return prompt.data();
      });
  el_set(editor, EL_GETCFN, &Keyboard::read_character);
  el_set(editor, EL_ADDFN, "complete", "complete a command", &Keyboard::complete);
  el_set(editor, EL_BIND, "\t", "complete", nullptr);
}

Keyboard& Keyboard::of(EditLine* editor) {
  void* keyboard = nullptr;
  el_get(editor, EL_CLIENTDATA, &keyboard);
  return *static_cast<Keyboard*>(keyboard);
}

std::optional<std::string> Keyboard::next() {
  for (;;) {
    if (!forget_ctrl_c()) throw_if_interrupted();
    int count = 0;
    const char* const text = el_gets(editor_.get(), &count);
    if (text != nullptr && count > 0) return remembered({text, static_cast<std::size_t>(count)});
    std::fputc('\n', isatty(STDOUT_FILENO) == 1 ? stdout : stderr);
    std::fflush(stdout);
    decoding_ = {};
    if (interrupt_signal() == 0) return std::nullopt;
  }
}

std::string Keyboard::remembered(std::string line) {
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
  HistEvent event;
  if (!line.empty()) history(history_.get(), &event, H_ENTER, line.c_str());
  return line;
}

// Stands in for the editor's own reader, which would try again after Ctrl-C.
int Keyboard::read_character(EditLine* editor, wchar_t* into) {
  Keyboard& keyboard = of(editor);
  for (;;) {
    char byte = 0;
    if (!wait_for_key()) return -1;
    const ssize_t count = ::read(STDIN_FILENO, &byte, 1);
    if (count == 0) return 0;
    if (count < 0) {
      if (errno == EINTR && interrupt_signal() == 0) continue;
      return -1;
    }
    const std::size_t length = std::mbrtowc(into, &byte, 1, &keyboard.decoding_);
    if (length <= 1) return 1;
    if (length == static_cast<std::size_t>(-1)) keyboard.decoding_ = {};
  }
}

unsigned char Keyboard::complete(EditLine* editor, int) {
  const LineInfo* const line = el_line(editor);
  const std::string_view typed(line->buffer, static_cast<std::size_t>(line->cursor - line->buffer));
  std::vector<std::string> fitting;
  for (const std::string& word : of(editor).words_) {
    if (word.starts_with(typed)) fitting.push_back(word);
  }
  if (fitting.empty() || line->cursor != line->lastchar) return CC_REFRESH_BEEP;
  const std::string rest =
      common_beginning(fitting).substr(typed.size()) + (fitting.size() == 1 ? " " : "");
  if (rest.empty()) return CC_REFRESH_BEEP;
  return el_insertstr(editor, rest.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
}

}  // namespace thiessen::cli
