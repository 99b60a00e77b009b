#pragma once

#include <cstddef>

namespace thiessen {

/// Whether the system would give this process so many bytes more at this moment: by the limit on
/// its address space (ulimit -v) and by what the machine has. Takes none of them.
bool can_have(std::size_t bytes) noexcept;

}  // namespace thiessen
