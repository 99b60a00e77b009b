#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include "rainfall/gaps/handover.h"

namespace thiessen {

/// Remembers the handovers of the components that were asked for lately, within a bound of memory.
/// Safe for several threads at once; the result depends on the component alone.
class HandoverCache {
 public:
  /// The handovers must outlive this object.
  HandoverCache(const Handovers& handovers, std::size_t bytes);

  std::shared_ptr<const Handover> of(std::span<const PlaceIndex> component);

 private:
  /// The handovers of components of one cell, which are the commonest and are found without a
  /// search. Each is computed once and kept to the end, while all of them are within half of the
  /// bound.
  class Singles {
   public:
    explicit Singles(std::size_t cells) : of_cell_(cells) {}
    Singles(const Singles&) = delete;
    Singles& operator=(const Singles&) = delete;
    ~Singles();
    const Handover* find(PlaceIndex cell) const {
      return of_cell_[index(cell)].load(std::memory_order_acquire);
    }
    const Handover* keep(PlaceIndex cell, std::unique_ptr<const Handover> handover);

   private:
    std::vector<std::atomic<const Handover*>> of_cell_;
  };

  using Component = std::vector<PlaceIndex>;
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::span<const PlaceIndex> component) const;
  };
  struct Equal {
    using is_transparent = void;
    bool operator()(std::span<const PlaceIndex> a, std::span<const PlaceIndex> b) const;
  };
  using Generation = std::unordered_map<Component, std::shared_ptr<const Handover>, Hash, Equal>;

  /// A part of the cache with a lock of its own. When the young generation is full it becomes the
  /// old one, and the old one is forgotten except for those that have been asked for since.
  struct Shard {
    std::mutex mutex;
    Generation young;
    Generation old;
    std::size_t young_bytes = 0;
  };

  std::shared_ptr<const Handover> find(Shard& shard, std::span<const PlaceIndex> component);
  void keep(Shard& shard, std::span<const PlaceIndex> component,
            const std::shared_ptr<const Handover>& handover);

  static constexpr std::size_t shard_count = 16;

  std::shared_ptr<const Handover> of_single(PlaceIndex cell);

  const Handovers& handovers_;
  Singles singles_;
  std::atomic<std::size_t> singles_bytes_left_;
  std::size_t generation_bytes_;  // the bound for one generation of a shard
  std::array<Shard, shard_count> shards_;
};

}  // namespace thiessen
