#pragma once

#include <fcntl.h>

#include <functional>
#include <string>
#include <vector>

#include "base/file.h"
#include "base/temporary_folder.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// What a writer puts into a file.
inline std::string written(const std::function<void(OutputFile&)>& write) {
  const TemporaryFolder folder;
  OutputFile file("out.csv", open_descriptor(folder.path("out.csv"), O_WRONLY | O_CREAT, 0600),
                  OutputFile::Care::closed);
  write(file);
  file.finish();
  return folder.read("out.csv");
}

/// Two basins of two gauges, whose ids want quotes: the one halves the first basin, and the other
/// has all of the second.
struct TwoBasins {
  std::vector<Basin> basins = {{"B,1", {{{{-1, -1}, {5, -1}, {5, 1}, {-1, 1}}, {}}}, {}},
                               {"C", {{{{3, -1}, {5, -1}, {5, 1}, {3, 1}}, {}}}, {}}};
  Network network{{{"a\"b", {0, 0}}, {"007", {4, 0}}}, Metric::planar};
  Weighing weighing{network, basins, {Metric::planar, 1, 0.1}};
};

}  // namespace thiessen
