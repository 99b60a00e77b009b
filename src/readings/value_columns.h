#pragma once

#include "base/error.h"
#include "readings/readings_layout.h"
#include "readings/readings_reader.h"
#include "text/table.h"

namespace thiessen {

/// Tells from which of several columns of values the readings of a long table are taken, where the
/// user names none, and warns where a column beside them (parameter, element) says of rows that
/// they are of something else than rain. Cost: the first 64 kB, read once more, where there is such
/// a column.
void tell_values(const Table& table, const ReadingsLayout& layout, const ReadingsOptions& options,
                 Warnings& warnings);

}  // namespace thiessen
