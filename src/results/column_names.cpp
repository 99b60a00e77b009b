#include "results/column_names.h"

#include <algorithm>
#include <unordered_set>

#include "base/error.h"
#include "base/utf8.h"

namespace thiessen {

Wording rows_or_other_ids() {
  return setting("long") + " has a row a basin, and " + setting("basin_id") +
         " takes the ids of another field";
}

void check_column_names(const std::vector<Basin>& basins, const std::string& suffix,
                        const Wording& hint) {
  std::unordered_set<std::string> ids;
  for (const Basin& basin : basins) ids.insert(basin.id);
  for (const Basin& basin : basins) {
    const std::string second = basin.id + suffix;
    if (ids.count(second) == 0) continue;
    throw Error({"", 0,
                 "basins " + quoted(basin.id) + " and " + quoted(second) +
                     " would both have a column of the latter name",
                 hint});
  }
}

void check_time_column(const std::vector<Basin>& basins, const Wording& hint) {
  const bool any = std::any_of(basins.begin(), basins.end(),
                               [](const Basin& basin) { return basin.id == "time"; });
  if (any)
    throw Error({"", 0, "the column of basin 'time' would be called as that of times", hint});
}

}  // namespace thiessen
