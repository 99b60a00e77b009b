#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/temporary_folder.h"
#include "cli/inputs/inputs.h"
#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/study_options.h"
#include "cli/options/given_options.h"

namespace thiessen::cli {

struct StudyAndRainfall {
  StudyOptions study;
  RainfallOptions rainfall;
};

/// The options of a study of gauges in a basin of 10 times 4, in a plane, and of its readings.
class GivenRainfall {
 public:
  /// `rainfall` is a table, `-` the standard input; empty: none is given.
  explicit GivenRainfall(const std::string& rainfall, const std::vector<std::string>& options = {},
                         const std::string& stations = "id,x,y\nA,0,2\nB,8,2\nC,9,3\n") {
    given_.block.study.declare(given_.options, Need::optional);
    given_.block.rainfall.declare(given_.options, Need::optional, given_.block.study.stations);
    std::vector<std::string> words = {
        folder_.write("s.csv", stations),
        folder_.write("b.csv", "id,WKT\nQ,\"POLYGON ((0 0,10 0,10 4,0 4,0 0))\"\n")};
    if (!rainfall.empty())
      words.push_back(rainfall == "-" ? rainfall : folder_.write("r.csv", rainfall));
    words.insert(words.end(), {"--metric", "planar"});
    words.insert(words.end(), options.begin(), options.end());
    given_.read(std::move(words));
  }

  const StudyOptions& study() const { return given_.block.study; }
  const RainfallOptions& rainfall() const { return given_.block.rainfall; }
  /// The inputs with the full network. To be asked for once.
  Inputs inputs() { return {study(), 0, rainfall(), 1, warnings}; }

  Warnings warnings;

 private:
  TemporaryFolder folder_;
  Given<StudyAndRainfall> given_;
};

inline std::vector<std::string> ids_of(const std::vector<Station>& stations) {
  std::vector<std::string> ids;
  for (const Station& station : stations) ids.push_back(station.id);
  return ids;
}

}  // namespace thiessen::cli
