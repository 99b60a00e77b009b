#pragma once

#include <string_view>

namespace thiessen {

/// Keeps what has failed, for the case that a library breaks off over it before it can be told:
/// libraries crash where they cannot read what they have just written. Up to 500 bytes of it are
/// kept, until something else fails. From any thread; takes no memory.
void note_last_words(std::string_view words) noexcept;
/// What was noted last; empty where nothing was.
std::string_view last_words() noexcept;

}  // namespace thiessen
