#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// The different times of a part of a file, numbered from 0 in the order in which they first came.
/// Times are compared as text. Memory: about 40 bytes a time, beside its text. Cost of entering a
/// time: a hash; only a comparison where it is the one entered last, or all so far came in sorting
/// order.
class ReadingsTimes {
 public:
  struct Entered {
    std::uint32_t step;
    bool fresh;  ///< whether it was not seen before
  };
  /// Enters a time that stands in `line`. Throws Error beyond 4 thousand million times.
  Entered enter(std::string_view time, std::size_t line);

  std::size_t size() const { return lines_.size(); }
  /// The memory in use, in bytes.
  std::size_t bytes() const {
    return texts_.size() + lines_.size() * (sizeof ends_[0] + sizeof lines_[0]) +
           slots_.size() * sizeof slots_[0];
  }
  std::string_view text(std::size_t step) const;
  /// The line in which the time first came.
  std::size_t line(std::size_t step) const { return lines_[step]; }

 private:
  /// A slot of the hash table: the step + 1, or 0 where it is free. The tag is a part of the time's
  /// hash, so that the texts of other times are hardly ever compared.
  struct Slot {
    std::uint32_t number = 0;
    std::uint32_t tag = 0;
  };

  Entered append(std::string_view time, std::size_t line);
  std::size_t slot_of(std::string_view time, std::size_t hash) const;
  void grow();

  std::string texts_;
  std::vector<std::size_t> ends_;  ///< where each time's text ends
  std::vector<std::size_t> lines_;
  std::vector<Slot> slots_;  ///< empty as long as each time sorts after the one before
  std::uint32_t last_ = 0;
};

}  // namespace thiessen
