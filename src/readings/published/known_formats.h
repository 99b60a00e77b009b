#pragma once

#include <vector>

#include "readings/published/published_format.h"

namespace thiessen {

/// All formats that are read without an option: those of the table, and those of which a reader of
/// their own makes a table. For the manual.
std::vector<PublishedFormat> known_formats();

}  // namespace thiessen
