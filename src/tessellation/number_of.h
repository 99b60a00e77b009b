#pragma once

#include <cstdint>
#include <functional>

#include "tessellation/topology.h"

namespace thiessen {

/// Gives the number by which the user knows a point, from 1.
using NumberOf = std::function<std::uint64_t(PointId)>;

}  // namespace thiessen
