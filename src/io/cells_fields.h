#pragma once

#include <string>
#include <vector>

#include "io/cells_file.h"
#include "text/attributes.h"

namespace thiessen {

/// The names of the stations' attributes beside the cells' own fields (station, basin, area_km2,
/// weight, rainfall): a name that is taken, case ignored, gets underscores.
std::vector<FieldName> attribute_fields(const CellsOutput& output);

}  // namespace thiessen
