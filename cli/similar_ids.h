#pragma once

#include <string>
#include <vector>

#include "rainfall/network.h"

namespace thiessen::cli {

/// The ids of stations that may be meant by a mistyped one: those that fewest insertions,
/// deletions, changes and exchanges of neighbouring characters make of it, at most one for
/// each three, and three ids at most, in file order. Case and blanks round it count for
/// nothing. Cost: the stations times the square of the ids' length.
std::vector<std::string> similar_ids(const std::string& id, const std::vector<Station>& stations);

}  // namespace thiessen::cli
