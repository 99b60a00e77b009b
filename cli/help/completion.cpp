#include "cli/help/completion.h"

namespace thiessen::cli {

std::string shell_quoted(const std::string& text, const std::string& quote) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += quote;
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

std::string in_few_words(const Option& option) {
  return option.help.substr(0, option.help.find("; "));
}

}  // namespace thiessen::cli
