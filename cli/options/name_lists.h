#pragma once

#include <string>
#include <vector>

namespace thiessen::cli {

/// Joins names for a sentence: `a, b and c`.
std::string and_list(const std::vector<std::string>& names);
/// Joins names for a sentence: `a, b or c`.
std::string or_list(const std::vector<std::string>& names);

/// The names that may be meant by `name`, an option or a command that does not exist: those that it
/// abbreviates, if these are three at most, else those that are like it (text/similar_texts.h).
/// Leading dashes are ignored.
std::vector<std::string> nearest_names(const std::string& name,
                                       const std::vector<std::string>& names);

}  // namespace thiessen::cli
