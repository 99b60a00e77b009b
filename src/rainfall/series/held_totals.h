#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "base/descriptor.h"
#include "base/file.h"

namespace thiessen {

/// The total of a basin over a period.
struct BasinTotal {
  double rainfall;      ///< sum of the steps' values; NaN where there is none
  std::size_t missing;  ///< steps without a value
  /// The standard error of the total, where errors are wanted and there is one; else NaN.
  double standard_error = std::numeric_limits<double>::quiet_NaN();
};

/// Holds the totals of periods until all are known, in their order. Memory: 16 MB; what is beyond
/// lies in a temporary file (see spool.h).
class HeldTotals {
 public:
  static constexpr std::size_t usual_memory = std::size_t{16} << 20;

  explicit HeldTotals(std::size_t memory = usual_memory) : memory_(memory) {}

  /// Adds a period's totals. No total may be taken before.
  void add(std::span<const BasinTotal> totals);
  /// Takes the totals of the next period, as many as were added. Throws Error where they cannot be
  /// read back.
  void take(std::span<BasinTotal> totals);

 private:
  void spill();

  std::size_t memory_;
  std::string bytes_;  // those held, or a window of those read back
  Descriptor spool_;
  std::optional<OutputFile> writer_;
  std::size_t at_ = 0;       // in bytes_
  std::size_t read_at_ = 0;  // in the spool
  bool taking_ = false;
};

}  // namespace thiessen
