#include "study/similar_ids.h"

#include "text/similar_texts.h"

namespace thiessen {

std::vector<std::string> similar_ids(const std::string& id, const std::vector<Station>& stations) {
  SimilarTexts similar(id);
  for (const Station& station : stations) similar.offer(station.id);
  return similar.found();
}

}  // namespace thiessen
