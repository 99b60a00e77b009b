#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/temporary_folder.h"
#include "cli/inputs/inputs.h"
#include "cli/options/blocks/study_options.h"
#include "cli/options/given_options.h"

namespace thiessen::cli {

/// Files of a study, and the options beside them. As it is: gauges whose bisector is x = 4 in a
/// basin of 10 times 4, so the weights are 0.4 and 0.6, in a plane without a CRS.
struct GivenFiles {
  std::string stations = "id,x,y,place\nA,0,2,hill\nB,8,2,vale\n";
  std::string basins = "id,WKT\nQ,\"POLYGON ((0 0,10 0,10 4,0 4,0 0))\"\n";  ///< empty: none
  std::vector<std::string> options = {"--metric", "planar"};
};

/// The inputs that a command makes of such files.
class GivenInputs {
 public:
  explicit GivenInputs(const GivenFiles& files = {}) : inputs(read(files), 0, 1, warnings) {}

  const StudyOptions& options() const { return given_.block; }

 private:
  const StudyOptions& read(const GivenFiles& files) {
    given_.block.declare(given_.options, Need::optional);
    given_.block.declare_attributes(given_.options);
    std::vector<std::string> words = {folder_.write("s.csv", files.stations)};
    if (!files.basins.empty()) words.push_back(folder_.write("b.csv", files.basins));
    words.insert(words.end(), files.options.begin(), files.options.end());
    given_.read(std::move(words));
    return given_.block;
  }

  TemporaryFolder folder_;
  Given<StudyOptions> given_;

 public:
  Warnings warnings;
  Inputs inputs;
};

/// Two gauges and a basin two kilometres wide on the central meridian of UTM's zone 33, in that
/// plane.
inline GivenFiles files_in_utm() {
  return {"id,x,y\nA,499100,5500000\nB,500900,5500500\n",
          "id,WKT\nQ,\"POLYGON ((499000 5500000,501000 5500000,501000 5502000,499000 5502000,"
          "499000 5500000))\"\n",
          {"--metric", "planar", "--crs", "EPSG:32633", "--basins-crs", "EPSG:32633"}};
}

/// A degree of longitude and latitude.
inline GivenFiles files_in_degrees() {
  return {"id,lon,lat\nA,15.1,50.5\nB,15.9,50.5\n",
          "id,WKT\nQ,\"POLYGON ((15 50,16 50,16 51,15 51,15 50))\"\n",
          {"--basins-crs", "EPSG:4326"}};
}

}  // namespace thiessen::cli
