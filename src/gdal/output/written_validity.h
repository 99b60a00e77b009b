#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace thiessen {

/// A geometry of a file that is no valid shape.
struct WrittenFault {
  std::size_t feature;  ///< its position in the file, from 0
  std::string reason;   ///< as validity_fault words it
};

/// Reads back a file that GDAL has written in a format that rounds coordinates (text, or whole
/// numbers), and finds the first geometry that is no valid shape after rounding. `file` is GDAL's
/// name of it, `driver` that of the format. Nothing is found in formats that keep doubles, whose
/// shapes are what was given to GDAL, and in those that GDAL only writes. Cost: linear in the file,
/// and a check of validity a feature.
std::optional<WrittenFault> fault_after_rounding(const std::string& file,
                                                 const std::string& driver);

}  // namespace thiessen
