#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "tessellation/cell.h"
#include "tessellation/number_of.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// Takes a text piece by piece, a line at a time.
using TextSink = std::function<void(std::string_view)>;

/// The topology table (section 2.4) as text, points in the order of their numbers, then vertices:
///
///     point ID X Y [Z]
///     vertex ID center X Y [Z] radius R forming F1 F2 F3 [F4] neighbors N1 N2 N3 [N4]
///
/// A vertex is called VertexId + 1 and keeps that number as long as it is there; neighbour i lies
/// across from forming point i, 0 where there is none. Numbers have the fewest digits that read
/// back to the same double; beyond the doubles they are `infinity`. Points that span less than the
/// plane or space have no vertices. Cost: n log n.
template <int Dimension>
void write_topology_table(const Tessellation<Dimension>& tessellation, const NumberOf& number_of,
                          const TextSink& write);

/// `X Y [Z]`
std::string position_text(const Point& position);
std::string position_text(const SpacePoint& position);

/// `point ID X Y [Z]`, with a line end.
template <int Dimension>
std::string point_line(const Tessellation<Dimension>& tessellation, const NumberOf& number_of,
                       PointId p);

/// A cell as text: its point as above, then
///
///     vertex ID center X Y radius R       counter-clockwise, unbounded cells from ray to ray
///     ray from ID direction DX DY         of an unbounded cell, its first edge and its last
///     area A                              `infinity` where it is unbounded
///     neighbors N1 N2 ...                 counter-clockwise
///
/// and in space, vertices being in the order of their coordinates, faces and neighbours in that of
/// the neighbours' numbers:
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
