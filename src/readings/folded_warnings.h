#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"

namespace thiessen {

/// Gathers what is said of many files, so that what is said of several alike is said once: of the
/// first, with the number of the others.
class FoldedWarnings {
 public:
  /// Takes what was said of one file.
  void add(const Warnings& of_file);
  /// Passes all on, in the order in which it first came.
  void pass_on(Warnings& warnings) const;

 private:
  /// A message, and how many more files it is about.
  struct Folded {
    Message first;
    bool is_notice = false;
    std::size_t others = 0;
    std::string last_file;
  };
  void add(const Message& message, bool is_notice);

  std::vector<Folded> all_;
  std::map<std::string, std::size_t> places_;  ///< in `all_`, by the text
};

}  // namespace thiessen
