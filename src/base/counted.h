#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace thiessen {

/// A count and what it counts: `1 reading is`, `2 readings are`, `0 readings are`.
inline std::string counted(std::size_t count, std::string_view one, std::string_view several) {
  std::string text = std::to_string(count) + " ";
  return text += count == 1 ? one : several;
}

/// The same of a thing whose plural is regular: `1 row`, `2 rows`, `0 rows`.
inline std::string counted(std::size_t count, std::string_view thing) {
  std::string text = std::to_string(count) + " ";
  text += thing;
  return count == 1 ? text : text + "s";
}

}  // namespace thiessen
