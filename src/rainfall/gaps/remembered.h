#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace thiessen {

/// Values by keys, which are lists of numbers. Those that were asked for lately are remembered
/// within a bound of memory. Safe for several threads at once.
template <typename Number, typename Value>
class Remembered {
 public:
  using Key = std::span<const Number>;

  /// The bound is that of keys, of values as `of` is told, and of what it takes to find them.
  explicit Remembered(std::size_t bytes) : generation_bytes_(bytes / shard_count / 2) {}

  /// The value of a key: what is remembered, or else what `compute()` gives. `bytes_of` tells how
  /// much memory a value holds beside itself. Several threads may compute the same value at once.
  template <typename Compute, typename BytesOf>
  std::shared_ptr<const Value> of(Key key, const Compute& compute, const BytesOf& bytes_of) {
    if (auto found = find(key)) return found;
    auto value = std::make_shared<const Value>(compute());
    keep(key, value, bytes_of(*value));
    return value;
  }

  /// What is remembered of a key, or null.
  std::shared_ptr<const Value> find(Key key) {
    Shard& shard = shard_of(key);
    const std::lock_guard lock(shard.mutex);
    return find(shard, key);
  }
  /// Remembers the value of a key, which holds `bytes` of memory beside itself.
  void keep(Key key, const std::shared_ptr<const Value>& value, std::size_t bytes) {
    Shard& shard = shard_of(key);
    const std::lock_guard lock(shard.mutex);
    keep(shard, key, Entry{value, bytes_of_an_entry + key.size_bytes() + bytes});
  }

 private:
  // An entry takes a node and a bucket of the map, and the counters of the shared pointer.
  static constexpr std::size_t bytes_of_an_entry = 160;
  static constexpr std::size_t shard_count = 16;

  struct Entry {
    std::shared_ptr<const Value> value;
    std::size_t bytes;
  };
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(Key key) const {
      std::uint64_t hash = key.size();
      for (const Number number : key) {
        hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 29;
      }
      return hash;
    }
  };
  struct Equal {
    using is_transparent = void;
    bool operator()(Key a, Key b) const {
      return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }
  };
  using Generation = std::unordered_map<std::vector<Number>, Entry, Hash, Equal>;

  /// A part of what is remembered with a lock of its own. When the young generation is full it
  /// becomes the old one, and the old one is forgotten except for those that have been asked for
  /// since.
  struct Shard {
    std::mutex mutex;
    Generation young;
    Generation old;
    std::size_t young_bytes = 0;
  };

  Shard& shard_of(Key key) { return shards_[(Hash{}(key) >> 32) % shard_count]; }

  std::shared_ptr<const Value> find(Shard& shard, Key key) {
    const auto young = shard.young.find(key);
    if (young != shard.young.end()) return young->second.value;
    const auto old = shard.old.find(key);
    if (old == shard.old.end()) return nullptr;
    const Entry entry = std::move(old->second);
    shard.old.erase(old);
    keep(shard, key, entry);
    return entry.value;
  }

  void keep(Shard& shard, Key key, const Entry& entry) {
    if (entry.bytes > generation_bytes_) return;
    if (shard.young_bytes + entry.bytes > generation_bytes_) {
      shard.old = std::move(shard.young);
      shard.young.clear();
      shard.young_bytes = 0;
    }
    if (shard.young.emplace(std::vector<Number>(key.begin(), key.end()), entry).second)
      shard.young_bytes += entry.bytes;
  }

  std::size_t generation_bytes_;  // the bound for one generation of a shard
  std::array<Shard, shard_count> shards_;
};

}  // namespace thiessen
