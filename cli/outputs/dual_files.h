#pragma once

#include <memory>
#include <string>

#include "base/outputs.h"
#include "cli/inputs/inputs.h"
#include "cli/options/blocks/dual_options.h"
#include "cli/options/blocks/study_options.h"
#include "files/geopackage_copy.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The files of `--delaunay` and `--neighbours`: what the cells say of the gauges. They appear with
/// the other outputs or not at all.
class DualFiles {
 public:
  /// Opens the files that are asked for; `output` is where triangles in place of the cells go.
  /// Throws Error where one of them may not be written, or no writer has its extension. `outputs`
  /// must outlive this object.
  DualFiles(Outputs& outputs, const DualOptions& options, const std::string& output);

  /// Writes the dual of the cells of the gauges that report; without `readings` all do. Tells of
  /// stations that share a place, and where there are no triangles.
  void write(const Inputs& inputs, const StudyOptions& study, const GaugeReadings* readings,
             const std::string& unit, unsigned threads, Warnings& warnings);

 private:
  Outputs& outputs_;
  std::string triangles_name_;
  OutputFile* triangles_ = nullptr;
  OutputFile* borders_ = nullptr;
  std::unique_ptr<GeoPackageCopy> older_;
};

}  // namespace thiessen::cli
