#pragma once

#include <histedit.h>

#include <cwchar>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace thiessen::cli {

/// Reads lines from a terminal: with a prompt, editing, earlier lines by the arrow keys, and
/// completion of a line's first word by the tab key.
class Keyboard {
 public:
  /// `words` are offered as the first word of a line. Requires that the standard input is a
  /// terminal.
  explicit Keyboard(std::vector<std::string> words);
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  /// Reads the next line; none at the end of the input. Ctrl-C drops what is typed and begins
  /// anew. Throws Interrupted after another signal.
  std::optional<std::string> next();

 private:
  /// The line without its end, kept for the arrow keys.
  std::string remembered(std::string line);
  static Keyboard& of(EditLine* editor);
  static int read_character(EditLine* editor, wchar_t* into);
  static unsigned char complete(EditLine* editor, int key);

  struct Closer {
    void operator()(EditLine* editor) const { el_end(editor); }
    void operator()(::History* history) const { history_end(history); }
  };
  std::vector<std::string> words_;
  std::unique_ptr<::History, Closer> history_;
  std::unique_ptr<EditLine, Closer> editor_;
  std::mbstate_t decoding_ = {};
};

}  // namespace thiessen::cli
