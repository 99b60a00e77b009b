#pragma once

#include <string>
#include <vector>

#include "basin/basin.h"

namespace thiessen {

/// Checks a table that has two columns for each basin, one named by its id and one by its id and
/// `suffix`. Throws Error where one basin's id is another's with the suffix, as two columns would
/// then have one name.
void check_column_names(const std::vector<Basin>& basins, const std::string& suffix);

}  // namespace thiessen
