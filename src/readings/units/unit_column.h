#pragma once

#include <memory>

#include "readings/readings_layout.h"
#include "readings/readings_reader.h"
#include "text/table.h"

namespace thiessen {

/// A long table whose rows say in a column of their own (unit, uom) what they are in: the table
/// with that as the unit of its values (see Table::unit). Any other table is passed on as it is.
///
/// Rows without a unit are in that of the others. Where neither the user nor a format says what the
/// readings are in, a unit that is none of rain is an error, and so are, when they are read, rows
/// of several. Throws Error.
std::unique_ptr<Table> with_unit_column(std::unique_ptr<Table> table, const ReadingsLayout& layout,
                                        const ReadingsOptions& options);

}  // namespace thiessen
