#pragma once

namespace thiessen::cli {

/// Has a lack of memory that nothing catches be told as such, instead of aborting the program. What
/// else nothing catches aborts it as before, in the C++ library's words.
void watch_for_uncaught() noexcept;

/// From now on a lack of memory is noted wherever it is met, also by libraries that tell it as
/// something else; where one breaks off for it, the program ends with a message, and in any case
/// without hidden files. Where the address space has a limit (ulimit -v) no thread takes a share of
/// it ahead.
void watch_for_lack_of_memory() noexcept;

/// Whether memory has been lacking since watch_for_lack_of_memory, or is all but used up now: then
/// it may be why something failed, whatever the message says.
bool memory_is_short() noexcept;

}  // namespace thiessen::cli
