#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace thiessen {

/// What a file is as one of readings, as far as its beginning tells.
enum class RainfallContent : std::uint8_t {
  readings,  ///< of a format that is known, or a table of stations, times and values
  unknown,   ///< a table of what only its reader knows, or no text
  none,  ///< surely no readings: prose such as a readme.txt, what is told of other files (JSON),
         ///< an agency's list of stations
};

/// Looks at the first 64 kB of a file, which may be packed or in an archive. What cannot be opened
/// is unknown: whoever reads it says so.
RainfallContent rainfall_content(const std::string& file);

/// The files that one of SWAT+'s or ArcSWAT's lists of files names; none of any other file, and of
/// one that cannot be read.
std::vector<std::string> files_listed_in(const std::string& file);

/// Whether a file is a list of files, and the first that it names holds no rain, but temperatures
/// or the like.
bool lists_no_rain(const std::string& file);

}  // namespace thiessen
