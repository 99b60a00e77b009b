#pragma once

#include <string>

#include "base/file.h"
#include "tessellation/number_of.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// The formats in which a tessellation goes into other programs.
enum class MeshFormat { obj, ply, geojson };

/// The format that the extension of a file's name tells. Throws Error, with those there are, where
/// it tells none, and where the format has no place for points of so many dimensions.
template <int Dimension>
MeshFormat mesh_format(const std::string& path);

/// Writes the Delaunay triangles of the plane, or the tetrahedra of space, with numbers in the
/// fewest digits that read back to the same double. Points stand in the order of their numbers, and
/// simplices in that of their vertices in the topology table.
///
/// - Wavefront OBJ: `v` for each point (z is 0 in the plane) and `f` for each triangle,
///   counter-clockwise. In space each tetrahedron is a group `tetrahedron_N` of four faces, named
///   by its vertex; after them each bounded Voronoi cell is a group `cell_N`, named by its point,
///   of polygons whose corners are further `v`. Faces are counter-clockwise from outside.
/// - PLY (ASCII): the points, with their numbers as a property, and triangles as faces; in space
///   four of them, one after the other, are a tetrahedron.
/// - GeoJSON, of the plane alone: a polygon for each triangle, with the properties a, b and c, the
///   numbers of its points, in the plane's own coordinates.
///
/// Where the points span less than the plane or space there are no simplices. Cost: linear, in
/// space for OBJ that of find_cell for each point.
template <int Dimension>
void write_mesh(OutputFile& file, MeshFormat format, const Tessellation<Dimension>& tessellation,
                const NumberOf& number_of);

}  // namespace thiessen
