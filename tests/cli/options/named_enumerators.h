#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace thiessen::cli {

/// The names of all enumerators, in their order. The switch behind `name` has no default, so that
/// none compiles without a name; a number that is no enumerator has none.
template <typename Enumeration>
std::vector<std::string> names_of_enumerators(const char* (*name)(Enumeration)) {
  std::vector<std::string> names;
  for (int number = 0; number < 100; ++number) {
    try {
      names.emplace_back(name(static_cast<Enumeration>(number)));
    } catch (const std::logic_error&) {
      continue;
    }
  }
  EXPECT_FALSE(names.empty());
  return names;
}

}  // namespace thiessen::cli
