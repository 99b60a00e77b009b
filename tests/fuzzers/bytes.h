#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace thiessen::fuzzers {

/// What a fuzzer is given, taken from the front; zeros after its end.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  bool empty() const { return left_.empty(); }
  std::uint8_t next() {
    if (left_.empty()) return 0;
    const std::uint8_t byte = left_.front();
    left_ = left_.subspan(1);
    return byte;
  }
  /// Below `end`, which is 256 at most.
  std::size_t below(std::size_t end) { return next() % end; }
  /// One of a list of 256 at most. Requires that it is not empty.
  template <typename List>
  const auto& one_of(const List& list) {
    return list[below(std::size(list))];
  }
  std::string_view rest() const {
    return {reinterpret_cast<const char*>(left_.data()), left_.size()};
  }
  /// Up to a byte, which is passed over, or all.
  std::string_view until(char end) {
    const std::string_view text = rest().substr(0, rest().find(end));
    left_ = left_.subspan(std::min(text.size() + 1, left_.size()));
    return text;
  }

 private:
  std::span<const std::uint8_t> left_;
};

/// Ends the run, with that sentence, where something is not as it must be.
inline void require(bool is_so, const std::string& sentence) {
  if (!is_so) throw std::logic_error(sentence);
}

}  // namespace thiessen::fuzzers
