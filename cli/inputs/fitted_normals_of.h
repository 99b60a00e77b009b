#pragma once

#include <cstddef>
#include <vector>

#include "base/error.h"
#include "cli/inputs/inputs.h"
#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/study_options.h"
#include "rainfall/series/stamp.h"

namespace thiessen::cli {

/// How normals are fitted to RAINFALL.
struct NormalFitting {
  /// What times are of their steps, where RAINFALL itself does not say it.
  Stamp stamp = Stamp::begin;
  std::size_t threads = 1;
};

/// Where the options ask for it, reads all of RAINFALL, fits normals by elevation, has gauges
/// weighed with them, and says what leaving each gauge out tells of them. Warnings of RAINFALL are
/// dropped here, as they are given when it is read again. Throws UsageError where there is no
/// series that can be read twice, and Error as normals_by_elevation does. Returns the elevations of
/// the stations; empty where nothing was fitted.
std::vector<double> fit_normals(Inputs& inputs, const StudyOptions& study,
                                const RainfallOptions& rainfall, const NormalFitting& fitting,
                                Warnings& warnings);

}  // namespace thiessen::cli
