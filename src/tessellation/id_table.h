#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace thiessen {

/// A hash table from keys of `Length` numbers to a number, in which an operation looks up the few
/// rows that it changes. It is emptied in one step. Cost: constant on average; it allocates only
/// when it grows beyond what it ever held.
template <std::size_t Length>
class IdTable {
 public:
  using Key = std::array<std::uint32_t, Length>;

  void clear() {
    count_ = 0;
    if (++round_ == 0) {
      for (Slot& slot : slots_) slot.round = 0;
      round_ = 1;
    }
  }
  std::size_t size() const { return count_; }

  /// The address of the key's value, or null where the key has none.
  std::uint32_t* find(const Key& key) {
    if (slots_.empty()) return nullptr;
    Slot& slot = slot_of(key);
    return slot.round == round_ ? &slot.value : nullptr;
  }
  /// Gives the key this value unless it has one already. Returns the key's value, and whether it is
  /// new.
  std::pair<std::uint32_t*, bool> insert(const Key& key, std::uint32_t value) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    Slot& slot = slot_of(key);
    if (slot.round == round_) return {&slot.value, false};
    slot = {key, value, round_};
    ++count_;
    return {&slot.value, true};
  }

 private:
  struct Slot {
    Key key;
    std::uint32_t value;
    std::uint32_t round = 0;  // the round in which the slot was taken
  };

  // Compares in place, because comparing arrays may compile to a library call.
  static bool are_equal(const Key& a, const Key& b) {
    std::uint32_t different = 0;
    for (std::size_t i = 0; i < Length; ++i) different |= a[i] ^ b[i];
    return different == 0;
  }
  Slot& slot_of(const Key& key) {
    std::uint64_t hash = 0;
    for (const std::uint32_t part : key) hash = (hash ^ part) * 0x9E3779B97F4A7C15u;
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = static_cast<std::size_t>(hash >> 32) & mask;
    while (slots_[i].round == round_ && !are_equal(slots_[i].key, key)) i = (i + 1) & mask;
    return slots_[i];
  }
  void grow() {
    constexpr std::size_t few = 32;
    std::vector<Slot> slots(std::max(few, 2 * slots_.size()));
    slots.swap(slots_);
    for (const Slot& slot : slots) {
      if (slot.round == round_) slot_of(slot.key) = slot;
    }
  }

  std::vector<Slot> slots_;
  std::uint32_t round_ = 1;
  std::size_t count_ = 0;
};

}  // namespace thiessen
