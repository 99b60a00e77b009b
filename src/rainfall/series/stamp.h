#pragma once

#include <cstdint>

namespace thiessen {

/// Whether the time of a step says when it begins or when it ends. A year, month or day is the
/// whole of it either way: a time says one or the other only where it has a clock.
enum class Stamp : std::uint8_t { begin, end };

}  // namespace thiessen
