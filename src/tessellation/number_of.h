#pragma once

#include <cstdint>
#include <functional>

#include "tessellation/topology.h"

namespace thiessen {

/// What a point is called, from 1.
using NumberOf = std::function<std::uint64_t(PointId)>;

}  // namespace thiessen
