#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

namespace thiessen {

/// Values by numbers from 0 on, each kept to the end once it is there and found without a search.
/// Safe for several threads at once. Memory: 8 bytes a number, and what is kept; its values and
/// what `keep` is told that they hold stay within a bound.
template <typename Value>
class Kept {
 public:
  Kept(std::size_t numbers, std::size_t bytes) : of_number_(numbers), bytes_left_(bytes) {}
  Kept(const Kept&) = delete;
  Kept& operator=(const Kept&) = delete;
  ~Kept() {
    for (const auto& value : of_number_) delete value.load(std::memory_order_relaxed);
  }

  /// The value of a number, or null. It is kept to the end, so its users are not counted.
  std::shared_ptr<const Value> find(std::size_t number) const {
    return uncounted(of_number_[number].load(std::memory_order_acquire));
  }
  /// Keeps a value, which holds `bytes` of memory beside itself, and gives what is kept; where the
  /// bound does not allow that, it gives the value back. If another thread has kept one before,
  /// that one stays.
  std::shared_ptr<const Value> keep(std::size_t number, std::unique_ptr<const Value> value,
                                    std::size_t bytes) {
    const std::size_t of_all = bytes + bytes_of_an_entry;
    std::size_t left = bytes_left_.load(std::memory_order_relaxed);
    do {
      if (left < of_all) return value;
    } while (!bytes_left_.compare_exchange_weak(left, left - of_all));
    const Value* known = nullptr;
    if (of_number_[number].compare_exchange_strong(known, value.get(), std::memory_order_acq_rel))
      return uncounted(value.release());
    bytes_left_ += of_all;
    return uncounted(known);
  }

 private:
  static constexpr std::size_t bytes_of_an_entry = sizeof(Value) + 32;

  static std::shared_ptr<const Value> uncounted(const Value* value) {
    return std::shared_ptr<const Value>(std::shared_ptr<const Value>(), value);
  }

  std::vector<std::atomic<const Value*>> of_number_;
  std::atomic<std::size_t> bytes_left_;
};

}  // namespace thiessen
