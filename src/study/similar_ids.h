#pragma once

#include <string>
#include <vector>

#include "rainfall/network/network.h"

namespace thiessen {

/// The ids of stations that may be meant by a mistyped one (text/similar_texts.h), three at most,
/// in file order. Cost: the stations times the square of the ids' length.
std::vector<std::string> similar_ids(const std::string& id, const std::vector<Station>& stations);

}  // namespace thiessen
