#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/file.h"
#include "cli/inputs/inputs.h"
#include "rainfall/findings/gauge_neighbours.h"
#include "rainfall/findings/reading_searches.h"
#include "results/findings_file.h"

namespace thiessen::cli {

/// Looks for readings that cannot be true while they pass, and says what is found: how many of each
/// kind and the first of them as lines, and all of them in a file where one is wanted.
class FindingsReport {
 public:
  /// The inputs must outlive this object, and so must the file, which may be null. `unit` is that
  /// of the readings, empty where it is not known.
  FindingsReport(const Inputs& inputs, const std::string& unit, std::size_t threads,
                 OutputFile* file);

  void see(const TimeStep& step) { searches_.see(step); }
  /// What is found; once, after the last step.
  std::string text();

 private:
  struct OfKind {
    std::size_t count = 0;
    std::vector<std::string> first = {};
  };

  void take(const ReadingFinding& finding);
  std::string told(const ReadingFinding& finding) const;
  std::string left_out() const;
  std::string found_none_of() const;
  std::string lines() const;
  std::string about_unit() const;
  const OfKind& of_kind(FindingKind kind) const {
    return kinds_.at(static_cast<std::size_t>(kind));
  }

  const Inputs& inputs_;
  std::string unit_;
  GaugeNeighbours neighbours_;
  ReadingSearches searches_;
  std::optional<FindingsFile> file_;
  std::array<OfKind, all_findings.size()> kinds_;  // by FindingKind
};

}  // namespace thiessen::cli
