#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "gdal/output/study_layers.h"

namespace thiessen::cli {

/// Keeps a series for the GeoPackage of the study, up to a million values: as rows of a table more
/// would be hundreds of megabytes, in a file and before that in memory.
class HeldRain {
 public:
  static constexpr std::size_t most_values = 1'000'000;

  void add(const std::string& time, std::span<const double> values);
  /// Whether there were more values than are kept.
  bool is_too_long() const { return !rain_.has_value(); }
  /// The series; nothing where it is too long. It is gone from here afterwards.
  std::optional<StudyLayers::Rain> take() { return std::move(rain_); }

 private:
  std::optional<StudyLayers::Rain> rain_ = StudyLayers::Rain{};
};

}  // namespace thiessen::cli
