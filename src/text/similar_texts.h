#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// How many insertions, deletions, changes and exchanges of neighbouring characters make one text
/// of another (F. J. Damerau, 1964; two neighbours change places once at most). Characters are
/// bytes. Cost: the product of the lengths.
std::size_t text_distance(std::string_view a, std::string_view b);

/// Finds the texts that may be meant by a mistyped one: those that are the fewest changes away from
/// it, at most one for each three of its characters, and the first three of them at most. Case and
/// blanks round a text count for nothing. A text of more than 64 characters is like no other.
class SimilarTexts {
 public:
  explicit SimilarTexts(std::string_view mistyped);

  /// Considers one more text. Cost: the square of the text's length at worst.
  void offer(const std::string& text);
  /// In the order in which they were offered, as they were written.
  const std::vector<std::string>& found() const { return found_; }

 private:
  std::string wanted_;
  std::size_t least_;
  std::vector<std::string> found_;
};

/// The hint `did you mean 'a' or 'b'?`; empty for none. Longer texts are cut at 80 characters.
std::string did_you_mean(const std::vector<std::string>& texts);

}  // namespace thiessen
