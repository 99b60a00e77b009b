#include "text/similar_texts.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t most_found = 3;
constexpr std::size_t longest_wanted = 64;
constexpr std::size_t longest_shown = 80;

}  // namespace

std::size_t text_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

SimilarTexts::SimilarTexts(std::string_view mistyped)
    : wanted_(lower_case(trimmed(mistyped))), least_((wanted_.size() + 1) / 3) {}

void SimilarTexts::offer(const std::string& text) {
  if (wanted_.size() > longest_wanted) return;
  const std::string offered = lower_case(trimmed(text));
  const std::size_t size = offered.size();
  if (std::max(size, wanted_.size()) - std::min(size, wanted_.size()) > least_) return;
  const std::size_t changes = text_distance(wanted_, offered);
  if (changes > least_) return;
  if (changes < least_) found_.clear();
  least_ = changes;
  if (found_.size() < most_found) found_.push_back(text);
}

std::string did_you_mean(const std::vector<std::string>& texts) {
  std::string hint;
  for (const std::string& text : texts)
    hint += (hint.empty() ? "did you mean " : " or ") + quoted(text, longest_shown);
  return hint.empty() ? hint : hint + "?";
}

}  // namespace thiessen
