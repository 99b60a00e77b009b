#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "map/sheet/picture.h"
#include "rainfall/gaps/gap_policy.h"
#include "report/thinned_series.h"
#include "results/summary_file.h"
#include "results/weights_file.h"

namespace thiessen {

/// All that the page of a study shows. Texts are UTF-8 and may hold anything.
struct Report {
  struct Input {
    std::string role;    ///< such as stations
    std::string name;    ///< of the file, without its folder
    std::string sha256;  ///< in hexadecimal digits, or why there is none
  };

  /// The map: cells with the rainfall that it shows at first, basins, gauges. A cell's gauge is one
  /// of the network's, which come first.
  const Picture* picture = nullptr;
  std::string unit;
  std::string depth_unit;           ///< of depths in a length of time: of rates in mm/h mm
  bool is_area_known = true;        ///< whether areas are in km2
  std::size_t network = 0;          ///< how many of the picture's gauges are the network's
  std::vector<std::size_t> places;  ///< by gauge of the network: its place
  std::vector<BasinSummary> basins;
  std::string remarks;  ///< what is to be said of the summary; lines
  std::vector<WeightRow> weights;
  bool has_factors = false;  ///< whether normals make factors beside the weights, of the year
  const ThinnedSeries* series = nullptr;
  Gaps gaps = Gaps::retessellate;  ///< what a step with silent gauges got
  bool has_totals = false;         ///< whether rain.csv has totals over periods, and not the steps
  std::vector<std::string> findings;  ///< texts of one line or of several aligned ones
  std::vector<std::pair<std::string, std::string>> made_by;  ///< names and values
  std::string options;                                       ///< lines
  std::vector<Input> inputs;
};

/// The page: one file of HTML with all that it needs in it, which asks no network for anything. No
/// text of the inputs becomes markup. The same report gives the same bytes. Cost: linear in the
/// vertices, the weights and the series that it holds.
std::string report_page(const Report& report);

}  // namespace thiessen
