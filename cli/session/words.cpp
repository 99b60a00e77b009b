#include "cli/session/words.h"

#include <algorithm>

#include "base/error.h"

namespace thiessen::cli {
namespace {

constexpr std::string_view blanks = " \t";

}  // namespace

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  for (;;) {
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(blanks)));
    if (line.empty() || line[0] == '#') return words;
    const bool is_quoted = line[0] == '"' || line[0] == '\'';
    const std::string_view quote = line.substr(0, is_quoted ? 1 : 0);
    line.remove_prefix(quote.size());
    std::size_t end = line.find_first_of(is_quoted ? quote : blanks);
    if (end == std::string_view::npos) {
      if (is_quoted) throw Error(Message{"", 0, "a quote is never closed", {}});
      end = line.size();
    }
    words.emplace_back(line.substr(0, end));
    line.remove_prefix(std::min(line.size(), end + quote.size()));
  }
}

}  // namespace thiessen::cli
