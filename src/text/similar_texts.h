#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// The edit distance of two texts: how many insertions, deletions, changes and exchanges of
/// neighbouring characters turn one into the other (F. J. Damerau, 1964; two neighbours change
/// places at most once). Characters are bytes. Cost: the product of the lengths.
std::size_t text_distance(std::string_view a, std::string_view b);

/// Finds the texts that may be meant by a mistyped one: those that are the fewest changes away from
/// it, at most one change for each three of its characters, and at most the first three such texts.
/// Case and blanks round a text are ignored. No text is similar to one of more than 64 characters.
class SimilarTexts {
 public:
  explicit SimilarTexts(std::string_view mistyped);

  /// Considers one more text. Cost: at worst the square of the text's length.
  void offer(const std::string& text);
  /// The similar texts as they were written, in the order in which they were offered.
  const std::vector<std::string>& found() const { return found_; }

 private:
  std::string wanted_;
  std::size_t least_;
  std::vector<std::string> found_;
};

/// The hint `did you mean 'a' or 'b'?`, or an empty text where there is none. Texts longer than 80
/// characters are cut.
std::string did_you_mean(const std::vector<std::string>& texts);

}  // namespace thiessen
