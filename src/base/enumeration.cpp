#include "base/enumeration.h"

#include <algorithm>
#include <vector>

#include "base/utf8.h"

namespace thiessen {

std::string enumerated(std::span<const std::string> first, std::size_t count) {
  std::string all;
  for (const std::string& text : first) {
    if (!all.empty()) all += ", ";
    all += text;
  }
  if (count > first.size()) all += " and " + std::to_string(count - first.size()) + " more";
  return all;
}

std::string enumerated_up_to(std::size_t at_most, std::span<const std::string> texts) {
  return enumerated(texts.first(std::min(at_most, texts.size())), texts.size());
}

std::string names_up_to(std::size_t at_most, std::span<const std::string> names,
                        std::size_t longest) {
  std::vector<std::string> first;
  for (const std::string& name : names.first(std::min(at_most, names.size())))
    first.push_back(quoted(name, longest));
  return enumerated(first, names.size());
}

}  // namespace thiessen
