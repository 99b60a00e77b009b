#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "base/descriptor.h"

namespace thiessen {

/// The name by which messages call the file that open_spool opens.
inline constexpr const char* spool_name = "temporary file in TMPDIR or /tmp";

/// Opens a file without a name, for output that has to wait. Nothing is left of it once it is
/// closed, however the program ends. It is in $TMPDIR, else in /tmp, else, where no folder can hold
/// such a file, in memory. Throws Error where none of these is possible.
Descriptor open_spool();

/// Reads into `into` what was written to the spool from byte `at` on, and returns how many bytes
/// that is, which is less than `into` holds only at the end. Throws Error where it cannot be read
/// back.
std::size_t read_spool(const Descriptor& spool, std::uint64_t at, std::span<char> into);

/// Passes all that was written to the spool to `take`, from its beginning and piece by piece.
/// Throws Error where it cannot be read back, Interrupted where a signal came, and whatever `take`
/// throws.
void copy_spool(const Descriptor& spool, const std::function<void(std::string_view)>& take);

}  // namespace thiessen
