#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "base/descriptor.h"

namespace thiessen {

/// What messages call the file below.
inline constexpr const char* spool_name = "temporary file in TMPDIR or /tmp";

/// A file without a name, for output that has to wait: nothing is left of it once it is closed,
/// however the program ends. It lies in $TMPDIR, else in /tmp, else (no folder that can hold such a
/// file) in memory. Throws Error where there is none of them.
Descriptor open_spool();

/// Fills `into` with what was written to the spool at byte `at` and after, and returns how many
/// bytes that is: fewer only where it ends. Throws Error where it cannot be read back.
std::size_t read_spool(const Descriptor& spool, std::uint64_t at, std::span<char> into);

/// Hands over all that was written to the spool, from its beginning and piece by piece. Throws
/// Error where it cannot be read back, Interrupted where a signal came, and whatever `take` throws.
void copy_spool(const Descriptor& spool, const std::function<void(std::string_view)>& take);

}  // namespace thiessen
