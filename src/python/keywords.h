#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "cli/options/common_options.h"
#include "cli/options/gap_options.h"
#include "cli/options/method_options.h"
#include "cli/options/option_list.h"
#include "cli/options/period_options.h"
#include "cli/options/rainfall_options.h"
#include "cli/options/study_options.h"
#include "cli/options/view_options.h"

namespace thiessen::python {

/// Keywords of a call with the texts that each is given: the program's long options with `_` in
/// place of `-`, and STATIONS, BASINS and RAINFALL. A flag has the text `true`.
using Keywords = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// Thrown for a keyword that no option has.
struct UnknownKeyword {
  std::string text;
};

/// The keywords of a study. They are the program's own options, so that they are read, checked and
/// explained as on the command line.
struct StudyKeywords {
  /// Throws UnknownKeyword, and UsageError for values that no option takes or that contradict each
  /// other. `has_readings` says whether readings are given in memory.
  StudyKeywords(const Keywords& keywords, bool has_readings, Warnings& warnings);

  cli::OptionList list;
  cli::StudyOptions study;
  cli::RainfallOptions rainfall;
  cli::ViewOptions view;
  cli::CommonOptions common;
};

/// The keywords of a series. Its readings are in memory, in the files of RAINFALL, or where the
/// study has them.
struct SeriesKeywords {
  /// Throws as StudyKeywords does.
  explicit SeriesKeywords(const Keywords& keywords);

  cli::OptionList list;
  std::string no_stations;  // there is no event among keywords of a series
  cli::RainfallOptions rainfall;
  cli::MethodOptions method;
  cli::GapOptions gaps;
  cli::PeriodOptions range;
  bool errors = false;
};

/// A text of the program's options as a caller in Python reads it: `--basin-id` is `basin_id`.
std::string in_python(const std::string& text);

}  // namespace thiessen::python
