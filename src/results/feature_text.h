#pragma once

#include <string>
#include <string_view>

#include "geometry/polygon.h"
#include "outlines/vertex_rounding.h"
#include "results/provenance.h"

namespace thiessen {

/// \file
/// The parts of a GeoJSON of polygons that every one of them has.

/// Appends the name of a member, with a comma before it unless it is the first of its object.
void append_name(std::string& out, std::string_view name);

/// Appends a shape as a geometry; null where it has no polygon.
void append_geometry(std::string& out, const MultiPolygon& shape, const VertexRounding& rounding);

/// Appends the member `made_by`, with what is known of how the file was made, and a comma. What the
/// values of rainfall are is left to a member of its own.
void append_provenance(std::string& out, const Provenance& made_by);

}  // namespace thiessen
