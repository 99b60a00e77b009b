#pragma once

#include <cstdint>
#include <span>

#include "base/file.h"
#include "results/models/stepped_series.h"

namespace thiessen {

/// A rain file of SWMM in its standard, user-prepared format: a line for each basin and step with
/// rain, `ID year month day hour minute value`, dated by the step's beginning. Steps without a line
/// are dry, so that a missing value cannot be told; each basin has a line for the first step,
/// whatever fell in it, for SWMM refuses a file that does not have a gage's station.
///
/// Source: US EPA, Storm Water Management Model User's Manual, Files Used by SWMM, Rainfall Files:
/// the standard user-prepared format, and what a rain gage has to say of it.
class SwmmSeries : public SteppedSeries {
 public:
  /// The file must outlive it. Throws Error where an id has blanks or other characters that end a
  /// word in SWMM, where two differ by case alone, and where the unit is neither mm nor in, nor one
  /// of these in an hour.
  SwmmSeries(OutputFile& file, ModelSubject subject);

 private:
  void write(const Steps& steps, Warnings& warnings) override;
  void append_step(std::int64_t begin, std::span<const double> rainfall, bool is_first);
  void tell_gage(const Steps& steps, Warnings& warnings) const;
  void warn_of_lost(Warnings& warnings) const;

  OutputFile& file_;
  std::size_t too_small_ = 0;  ///< values above 0 that its decimals do not show
  double lost_ = 0;            ///< their sum
};

}  // namespace thiessen
