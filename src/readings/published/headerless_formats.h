#pragma once

#include <span>
#include <string_view>

#include "readings/published/published_format.h"

namespace thiessen {

/// The formats whose files have no header. Their columns are called as their publisher describes
/// them.
std::span<const PublishedFormat> headerless_formats();

/// The format whose rows these are with which a text begins, or null.
const PublishedFormat* format_of_rows(std::string_view beginning);

}  // namespace thiessen
