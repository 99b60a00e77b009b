#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace thiessen {

/// The first of `count` texts for a message, and how many the others are: `a, b and 7 more`.
std::string enumerated(std::span<const std::string> first, std::size_t count);

/// At most so many of some texts for a message, and how many the others are.
std::string enumerated_up_to(std::size_t at_most, std::span<const std::string> texts);

/// The same of names, each in quotes and cut to `longest` bytes (see quoted).
std::string names_up_to(std::size_t at_most, std::span<const std::string> names,
                        std::size_t longest = 400);

}  // namespace thiessen
