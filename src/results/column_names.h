#pragma once

#include <string>
#include <vector>

#include "basin/basin.h"

namespace thiessen {

/// Of a table that has for each basin a column of its id, and one of its id and `suffix`: throws
/// Error where one basin's id is another's with the suffix.
void check_column_names(const std::vector<Basin>& basins, const std::string& suffix);

}  // namespace thiessen
