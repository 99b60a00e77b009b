#pragma once

#include <string>

namespace thiessen::cli {

/// A wrong command line: exit status 2.
struct UsageError {
  std::string text;
  std::string hint;
};

}  // namespace thiessen::cli
