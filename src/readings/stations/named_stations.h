#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace thiessen {

/// How many stations a message names before it only counts them.
inline constexpr std::size_t stations_named = 10;

/// The names of the first of `count` stations: "'A', 'B' and 3 more" where there are more.
std::string named(const std::vector<std::string>& first, std::size_t count);

/// Says that `count` stations, at least one, have no readings, and what comes of it, and names the
/// first of them: "2 stations have no readings, and no cell: 'A', 'B'".
std::string without_readings(const std::vector<std::string>& first, std::size_t count,
                             const std::string& what_comes_of_it);

}  // namespace thiessen
