#pragma once

#include <string>
#include <vector>

#include "text/table.h"

namespace thiessen {

/// The first row of a table, as texts of its own; empty where it cannot be seen before it is read.
std::vector<std::string> first_row(const Table& table);

}  // namespace thiessen
