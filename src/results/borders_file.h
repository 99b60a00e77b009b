#pragma once

#include "base/file.h"
#include "rainfall/network/network_dual.h"

namespace thiessen {

/// Writes who borders whom as CSV, `station,neighbour,length`: a row a pair, in the order of the
/// dual. A border that never ends is `inf` long; others have the fewest digits that read back to
/// the same double.
void write_borders(OutputFile& file, const Network& network, const NetworkDual& dual);

}  // namespace thiessen
