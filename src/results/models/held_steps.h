#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "base/descriptor.h"
#include "base/file.h"

namespace thiessen {

/// Holds the steps of a series in a temporary file (see spool.h) until all are known, and hands
/// them out again by step or by basin.
class HeldSteps {
 public:
  /// How many bytes the values may take that are handed out by basin at once.
  static constexpr std::size_t usual_memory = std::size_t{64} << 20;

  explicit HeldSteps(std::size_t basins, std::size_t memory = usual_memory);

  /// Adds a step: its time in seconds, and a value for each basin. None may be added once they are
  /// handed out.
  void add(std::int64_t seconds, std::span<const double> values);
  std::size_t count() const { return count_; }

  using TakeStep = std::function<void(std::int64_t seconds, std::span<const double> values)>;
  /// Hands out all steps in their order. Memory: a megabyte, or a step. Throws Error where they
  /// cannot be read back, Interrupted where a signal came, and whatever `take` throws.
  void by_step(const TakeStep& take);

  using TakeBasin = std::function<void(std::size_t basin, std::span<const double> values)>;
  /// Hands out the values of one basin after the other, each by step. Memory: what was allowed, or
  /// one basin's values; cost: the file is read once for so many basins as fit into that.
  void by_basin(const TakeBasin& take);

 private:
  void write_rest();

  std::size_t basins_;
  std::size_t memory_;
  std::size_t count_ = 0;
  Descriptor spool_;
  std::optional<OutputFile> writer_;  ///< nothing once steps are handed out
};

}  // namespace thiessen
