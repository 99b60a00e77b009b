#pragma once

#include <string>

#include "base/error.h"

namespace thiessen {

/// The file of readings in a zip archive that holds several tables, as agencies ship it with what
/// tells of them: the path of the one whose content is known (see RainfallContent), or of the only
/// one that is a table at all. A notice tells it. Of any other file this is the file itself,
/// whose reader says what is wrong with it. Throws Error where an archive is damaged, or holds
/// several files of readings, which it names.
std::string file_of_readings(const std::string& rainfall, Warnings& warnings);

}  // namespace thiessen
