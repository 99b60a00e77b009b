#include "cli/options/blocks/dual_options.h"

#include <utility>

#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

void DualOptions::declare(OptionList& options) {
  OptionGroup group = options.group("Output", *this);
  OptionValue triangles = file(delaunay, "[FILE]");
  triangles.when_left_out = in_place;
  delaunay_option_ = &group.add(
      "--delaunay", std::move(triangles),
      "write the Delaunay triangles of the gauges: each three whose cells meet at a vertex, with "
      "their ids as a, b and c, counter-clockwise. GeoJSON, or any vector format by extension; "
      "without FILE, to -o in place of the cells. Not clipped; on the Earth with geodesics for "
      "sides, and without gauges whose cells meet on the far side of the Earth alone");
  neighbours_option_ = &group.add(
      "--neighbours", file(neighbours, "FILE"),
      "write who borders whom: CSV station,neighbour,length, a row a pair, over the whole border "
      "of both cells, not clipped, in metres (in a plane in its unit); inf where it never ends. "
      "Where --delaunay FILE or this is given and -o is not, no cells are written");
}

void DualOptions::check(bool output_is_stream) const {
  const bool both = delaunay == "-" && neighbours == "-";
  const bool beside_output = output_is_stream && (delaunay == "-" || neighbours == "-");
  if (both || beside_output)
    throw UsageError{"two outputs cannot both be the standard output", "give one of them a FILE"};
}

}  // namespace thiessen::cli
