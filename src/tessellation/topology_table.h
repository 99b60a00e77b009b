#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "tessellation/cell.h"
#include "tessellation/number_of.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// Receives a text piece by piece, one line at a time.
using TextSink = std::function<void(std::string_view)>;

/// Writes the topology table (section 2.4) as text: the points in the order of their numbers, then
/// the vertices.
///
///     point ID X Y [Z]
///     vertex ID center X Y [Z] radius R forming F1 F2 F3 [F4] neighbors N1 N2 N3 [N4]
///
/// A vertex is called VertexId + 1 and keeps that number as long as it is there. Neighbour i lies
/// across from forming point i; it is 0 where there is none. Numbers have the fewest digits that
/// read back to the same double; those beyond the doubles are `infinity`. Points that span less
/// than the plane or space have no vertices. Cost: n log n.
template <int Dimension>
void write_topology_table(const Tessellation<Dimension>& tessellation, const NumberOf& number_of,
                          const TextSink& write);

/// The position as text: `X Y [Z]`.
std::string position_text(const Point& position);
std::string position_text(const SpacePoint& position);

/// The line of a point in the topology table: `point ID X Y [Z]`, with a line end.
template <int Dimension>
std::string point_line(const Tessellation<Dimension>& tessellation, const NumberOf& number_of,
                       PointId p);

/// The text of a cell. It begins with the line of its point (see point_line), and then has in the
/// plane
///
///     vertex ID center X Y radius R       counter-clockwise, unbounded cells from ray to ray
///     ray from ID direction DX DY         the first and the last edge of an unbounded cell
///     area A                              `infinity` where the cell is unbounded
///     neighbors N1 N2 ...                 counter-clockwise
///
/// and in space, where vertices are in the order of their coordinates, and faces and neighbours in
/// the order of the neighbours' numbers:
///
///     vertex ID center X Y Z radius R
///     ray from ID direction DX DY DZ
///     face neighbor N area A vertices ID1 ID2 ID3 ...
///     volume V
///     neighbors N1 N2 ...
std::string cell_text(const Tessellation<2>& tessellation, const NumberOf& number_of,
                      const PlaneCell& cell);
std::string cell_text(const Tessellation<3>& tessellation, const NumberOf& number_of,
                      const SpaceCell& cell);

}  // namespace thiessen
