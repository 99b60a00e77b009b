#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/descriptor.h"
#include "base/file.h"
#include "rainfall/findings/finding_search.h"

namespace thiessen {

/// Findings that wait for the end of the readings, which says which of them count: some in memory,
/// and from a megabyte on in a temporary file (see spool.h).
class HeldFindings {
 public:
  void add(const ReadingFinding& finding);
  /// Passes all of them on, in the order in which they came. Once.
  void pass_on(const TakeFinding& take);

 private:
  void spill();
  /// Passes on what stands whole in the bytes, and returns how many bytes that is.
  static std::size_t pass_on(std::string_view bytes, const TakeFinding& take);

  std::string held_;
  Descriptor file_;
  std::optional<OutputFile> writer_;
};

}  // namespace thiessen
