#pragma once

#include <string>

namespace thiessen::cli {

/// Thrown for a wrong command line: the program ends with exit status 2.
struct UsageError {
  std::string text;
  std::string hint;
};

}  // namespace thiessen::cli
