#pragma once

#include <optional>
#include <string>

#include "cli/inputs/inputs.h"
#include "rainfall/series/rain_totals.h"

namespace thiessen::cli {

/// Settles what totals want to know of RAINFALL beforehand.
///
/// Storms want the step of the file. Has totals of readings that are rates, such as mm/h, count
/// each times the length of its step, and says so. For that RAINFALL is read once more beforehand;
/// readings of any other `unit` cost nothing. Where RAINFALL can be read only once the totals find
/// the length out themselves. Throws Error where it is not known, for the times have no regular
/// step.
void settle_totals(Totalling& totalling, Inputs& inputs, const StudyOptions& study,
                   const RainfallOptions& rainfall, const std::string& unit, Warnings& warnings);

/// The unit of the values that are written of readings in `unit`: where totals of rates are, that
/// of their depths.
std::string unit_of_values(const std::string& unit, const std::optional<Totalling>& totalling);

}  // namespace thiessen::cli
