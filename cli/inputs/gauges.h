#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/inputs/inputs.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The readings that cells and pictures show: the step at `time`, or the means where no time is
/// given; none without RAINFALL. Throws Error where RAINFALL has no such time or no time at all.
std::optional<GaugeReadings> shown_readings(Inputs& inputs, const StudyOptions& study,
                                            const RainfallOptions& rainfall,
                                            const std::string& time, Warnings& warnings);

/// The steps at these times of readings that are open, in their order; `name` is that of the
/// readings in messages. Throws Error, naming each time that they lack.
std::vector<GaugeReadings> shown_steps(Readings& readings, const Network& network,
                                       const std::string& name, std::span<const std::string> times,
                                       Warnings& warnings);

/// Throws Error where calendar months have normals of their own, and a step tells no month.
/// `rainfall` is for messages.
void require_months(const Inputs& inputs, const std::string& rainfall,
                    std::span<const GaugeReadings> steps);

/// Says that means over all steps are shown by the year's normals, where months have their own.
void tell_of_year(const Inputs& inputs, const RainfallOptions& rainfall, Warnings& warnings);

/// What readings are called to be in: their own unit where that is known, else what `--units` says.
/// Throws Error where it says another; `file` is for the message.
std::string unit_shown(const std::string& known, const std::string& said, bool is_said,
                       const std::string& file);
/// The steps at these times, in their order. Throws Error, naming each time that RAINFALL lacks.
std::vector<GaugeReadings> shown_steps(Inputs& inputs, const StudyOptions& study,
                                       const RainfallOptions& rainfall,
                                       std::span<const std::string> times, Warnings& warnings);

}  // namespace thiessen::cli
