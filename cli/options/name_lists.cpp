#include "cli/options/name_lists.h"

#include <algorithm>
#include <cstddef>

#include "text/similar_texts.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t most_names = 3;

std::string list(const std::vector<std::string>& names, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : last) + names[i];
  return text;
}

std::string without_dashes(const std::string& name) {
  return name.substr(std::min(name.size(), name.find_first_not_of('-')));
}

}  // namespace

std::string and_list(const std::vector<std::string>& names) {
  return list(names, " and ");
}

std::string or_list(const std::vector<std::string>& names) {
  return list(names, " or ");
}

std::vector<std::string> nearest_names(const std::string& name,
                                       const std::vector<std::string>& names) {
  const std::string wanted = without_dashes(name);
  std::vector<std::string> abbreviated;
  SimilarTexts similar(wanted);
  for (const std::string& candidate : names) {
    const std::string bare = without_dashes(candidate);
    if (!wanted.empty() && bare.starts_with(wanted)) abbreviated.push_back(candidate);
    similar.offer(bare);
  }
  if (!abbreviated.empty() && abbreviated.size() <= most_names) return abbreviated;
  std::vector<std::string> nearest;
  for (const std::string& candidate : names) {
    const auto& found = similar.found();
    if (std::find(found.begin(), found.end(), without_dashes(candidate)) != found.end())
      nearest.push_back(candidate);
  }
  return nearest;
}

}  // namespace thiessen::cli
