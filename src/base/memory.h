#pragma once

#include <cstddef>

namespace thiessen {

/// Whether the system would give this process so many bytes more at this moment: by the limit on
/// its address space (ulimit -v) and by what the machine has. Takes none of them.
bool can_have(std::size_t bytes) noexcept;

/// Notes that an allocation has failed, whatever is made of it then: libraries tell that as
/// something else, or not at all. From any thread.
void note_lack_of_memory() noexcept;
/// Whether that was noted since the last `forget_lack_of_memory`.
bool has_lacked_memory() noexcept;
void forget_lack_of_memory() noexcept;

}  // namespace thiessen
