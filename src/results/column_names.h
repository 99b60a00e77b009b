#pragma once

#include <string>
#include <vector>

#include "base/wording.h"
#include "basin/basin.h"

namespace thiessen {

/// What to do where two columns would have one name, as the settings of the program's series have
/// it.
Wording rows_or_other_ids();

/// Checks a table that has two columns for each basin, one named by its id and one by its id and
/// `suffix`. Throws Error where one basin's id is another's with the suffix, as two columns would
/// then have one name.
void check_column_names(const std::vector<Basin>& basins, const std::string& suffix,
                        const Wording& hint = rows_or_other_ids());

/// Checks a table that begins with a column `time` and has a column for each basin, named by its
/// id. Throws Error where a basin is called so: whoever reads the table by names would take its
/// rainfall for the times.
void check_time_column(const std::vector<Basin>& basins, const Wording& hint = rows_or_other_ids());

}  // namespace thiessen
