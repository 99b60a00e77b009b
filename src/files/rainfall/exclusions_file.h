#pragma once

#include <string>

#include "base/error.h"
#include "readings/excluded_readings.h"

namespace thiessen {

/// Reads a list of readings that are to count as missing: a CSV, or any other table, with a column
/// of stations and one of times, as `check` writes its findings; a row without a time means all
/// readings of its station. Throws Error where there are no such columns, where a row names no
/// station, and where the file can be read only once, for it is read several times.
ExclusionList read_exclusions(const std::string& file, Warnings& warnings);

}  // namespace thiessen
