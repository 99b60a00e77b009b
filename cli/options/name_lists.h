#pragma once

#include <string>
#include <vector>

namespace thiessen::cli {

/// `a, b and c`, for sentences.
std::string and_list(const std::vector<std::string>& names);
/// `a, b or c`.
std::string or_list(const std::vector<std::string>& names);

/// The names that may be meant by one that does not exist, as of an option or a command: those
/// that it abbreviates, if these are three at most, else those that are like it
/// (text/similar_texts.h). Dashes in front count for nothing.
std::vector<std::string> nearest_names(const std::string& name,
                                       const std::vector<std::string>& names);

}  // namespace thiessen::cli
