#include "results/column_names.h"

#include <unordered_set>

#include "base/error.h"
#include "base/utf8.h"

namespace thiessen {

void check_column_names(const std::vector<Basin>& basins, const std::string& suffix) {
  std::unordered_set<std::string> ids;
  for (const Basin& basin : basins) ids.insert(basin.id);
  for (const Basin& basin : basins) {
    const std::string second = basin.id + suffix;
    if (ids.count(second) == 0) continue;
    throw Error({"", 0,
                 "basins " + quoted(basin.id) + " and " + quoted(second) +
                     " would both have a column of the latter name",
                 setting("long") + " has a row a basin"});
  }
}

}  // namespace thiessen
