#pragma once

#include <string>
#include <vector>

namespace thiessen::cli {

/// Sets rows of text in aligned columns: the first column flush left, the others flush right. Each
/// character of UTF-8 counts as one wide.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace thiessen::cli
