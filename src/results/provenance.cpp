#include "results/provenance.h"

#include "base/number.h"

namespace thiessen {

std::vector<std::pair<std::string, std::string>> items_of(const Provenance& provenance) {
  std::vector<std::pair<std::string, std::string>> items;
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) items.emplace_back(name, value);
  };
  add("software", provenance.software);
  add("metric", provenance.metric);
  add("plane", provenance.plane);
  add("tolerance", shortest_text(provenance.tolerance));
  add("method", provenance.method);
  add("normals", provenance.normals);
  add("unit", provenance.unit);
  add("rainfall", provenance.rainfall);
  return items;
}

std::string sentence_of(const Provenance& provenance) {
  std::string sentence;
  for (const auto& [name, value] : items_of(provenance))
    sentence += sentence.empty() ? value : "; " + name + ": " + value;
  return sentence;
}

}  // namespace thiessen
