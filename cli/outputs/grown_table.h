#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/destination.h"
#include "base/error.h"
#include "base/grown_file.h"
#include "base/outputs.h"
#include "results/earlier_rain.h"
#include "results/rain_growth.h"

namespace thiessen::cli {

/// A table of rain that an earlier run has written, and to which this one adds what it lacks:
/// whole or not at all, or, where the readings come by a pipe, step by step in place.
class GrownTable {
 public:
  /// Opens the table, if there is one, and locks it. Throws Error: see GrownFile.
  GrownTable(const std::string& path, const OutputRules& rules, bool in_place);

  /// The output that rows are added to, once the columns are known. `format` is told whether there
  /// is a header already. Throws Error: see EarlierRain.
  OutputFile& begin(const std::vector<Basin>& basins, RainFormat& format, bool has_totals,
                    Warnings& warnings);
  RainGrowth* growth() { return &*growth_; }
  /// Lets those who read the table see what was added so far, where it grows in place.
  void pass_on(Warnings& warnings);
  /// Puts the longer table in place, and says how much longer it is.
  void finish(Warnings& warnings);

 private:
  void copy(std::size_t bytes, OutputFile& to) const;

  std::string path_;
  bool in_place_;
  GrownFile file_;
  Outputs outputs_;
  OutputFile* replacement_ = nullptr;
  std::optional<EarlierRain> earlier_;
  std::optional<RainGrowth> growth_;
};

}  // namespace thiessen::cli
