#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "readings/published/published_format.h"

namespace thiessen {

/// The formats that are tables, known by their header and, where their columns have common names,
/// by the lines above it. The first that fits is taken.
std::span<const PublishedFormat> published_formats();

/// Whether a text begins with the lines that stand above the header of one of these formats.
bool begins_as_published(std::string_view beginning);

/// What a table is called that has the columns of a format but for those of its rain, or is a
/// publisher's of other weather; empty where it is none, where its columns have common names, or
/// where one of them tells of rain.
std::string_view format_without_rain(const std::vector<std::string>& header,
                                     std::string_view beginning);

/// The format that a header belongs to, or null. `beginning`: the text above and below it, as far
/// as it is known, in UTF-8.
const PublishedFormat* format_of_header(const std::vector<std::string>& header,
                                        std::string_view beginning = {});

}  // namespace thiessen
