#include "cli/similar_ids.h"

#include <algorithm>
#include <cstddef>

#include "base/utf8.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t most_ids = 3;
constexpr std::size_t longest_id = 64;

/// How many changes make one text of another (F. J. Damerau, 1964; neighbours change places once).
std::size_t distance(const std::string& a, const std::string& b) {
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

}  // namespace

std::vector<std::string> similar_ids(const std::string& id, const std::vector<Station>& stations) {
  const std::string wanted = lower_case(trimmed(id));
  std::size_t least = (wanted.size() + 1) / 3;
  std::vector<std::string> similar;
  if (wanted.size() > longest_id) return similar;
  for (const Station& station : stations) {
    const std::size_t size = station.id.size();
    if (std::max(size, wanted.size()) - std::min(size, wanted.size()) > least) continue;
    const std::size_t changes = distance(wanted, lower_case(trimmed(station.id)));
    if (changes > least) continue;
    if (changes < least) similar.clear();
    least = changes;
    if (similar.size() < most_ids) similar.push_back(station.id);
  }
  return similar;
}

}  // namespace thiessen::cli
