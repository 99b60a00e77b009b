#pragma once

#include <memory>
#include <span>
#include <string>

#include "readings/readings_reader.h"

namespace thiessen {

/// Opens RAINFALL as the user names it: `.dly` files of GHCN-Daily (see open_dly_readings), or a
/// table (see open_table; `separator` applies to a CSV), whose readings are interpreted as
/// open_readings says. Throws Error as these functions do.
std::unique_ptr<Readings> open_rainfall(const std::string& rainfall, char separator,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings);

}  // namespace thiessen
