#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "cli/options/blocks/common_options.h"
#include "cli/options/blocks/gap_options.h"
#include "cli/options/blocks/method_options.h"
#include "cli/options/blocks/period_options.h"
#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/study_options.h"
#include "cli/options/blocks/view_options.h"
#include "cli/options/blocks/what_if_options.h"
#include "cli/options/option_list.h"

namespace thiessen::python {

/// Keywords of a call with the texts that each is given: the program's long options with `_` in
/// place of `-`, and STATIONS, BASINS and RAINFALL. A flag has the text `true`.
using Keywords = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// Thrown for a keyword that no option has, or that is another call's.
struct UnknownKeyword {
  std::string text;
};

/// The calls that take keywords.
enum class Call { study, weights, cells, rain, influence };

/// The keywords of each call, with the name of the call, as a caller writes both.
std::vector<std::pair<std::string, std::vector<std::string>>> keywords_of_calls();

/// Which parts of a study are in the caller's memory, and in no file.
struct HeldParts {
  bool stations = false;
  bool basins = false;
  bool readings = false;
};

/// The keywords of a study. They are the program's own options, so that they are read, checked and
/// explained as on the command line.
struct StudyKeywords {
  /// Declares them, with none given.
  explicit StudyKeywords(Call call);
  /// Throws UnknownKeyword, and UsageError for values that no option takes, for keywords that
  /// contradict each other, and for those that are about a file where there is none. `call` is
  /// Call::study or, for a study with gauges that open and close, Call::weights.
  StudyKeywords(const Keywords& keywords, HeldParts held, Call call, Warnings& warnings);

  cli::OptionList list;
  cli::StudyOptions study;
  cli::RainfallOptions rainfall;
  cli::ViewOptions view;
  cli::WhatIfOptions changes;
  cli::CommonOptions common;
};

/// Where the readings of a series are.
enum class ReadingsAt {
  memory,        ///< without times
  dated_memory,  ///< with a time for each row
  files,         ///< that the call names, or the study
  unknown,       ///< not yet told
};

/// The keywords of a series.
struct SeriesKeywords {
  /// Declares them, with none given. `call` is Call::rain or Call::influence, which takes fewer.
  explicit SeriesKeywords(Call call);
  /// Throws as StudyKeywords does.
  /// `stamp_acts`: the study has normals or totals, of which what times are of their steps decides
  /// whose month they are, or when they ended.
  SeriesKeywords(const Keywords& keywords, ReadingsAt readings, Call call, bool stamp_acts);

  cli::OptionList list;
  std::string no_stations;  // there is no event among keywords of a series
  cli::RainfallOptions rainfall;
  cli::MethodOptions method;
  cli::GapOptions gaps;
  cli::PeriodOptions range;
  bool errors = false;

 private:
  void check_readings(ReadingsAt readings) const;
};

/// The keywords of cells.
struct CellsKeywords {
  CellsKeywords();
  /// Throws as StudyKeywords does.
  explicit CellsKeywords(const Keywords& keywords);

  cli::OptionList list;
  cli::ViewOptions view;
};

/// A keyword by the name of its setting or option, without its dashes: `from` is a word of Python's
/// own, and `from_` the keyword.
std::string keyword_name(std::string name);

/// A text of the program's options as a caller in Python reads it: `--basin-id` is `basin_id`, and
/// BASINS is `basins`.
std::string in_python(const std::string& text);

}  // namespace thiessen::python
