#include "text/lines_of_files.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace thiessen {

void LinesOfFiles::begin(std::string file) {
  files_.push_back({std::move(file), last_});
}

RowPlace LinesOfFiles::place(std::size_t number) const {
  const auto behind =
      std::lower_bound(files_.begin(), files_.end(), number,
                       [](const File& file, std::size_t wanted) { return file.before < wanted; });
  const File& file = *std::prev(behind);
  return {file.name, number - file.before, {}};
}

}  // namespace thiessen
