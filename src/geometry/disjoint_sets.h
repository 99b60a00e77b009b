#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace thiessen {

/// Things, by number, of which some turn out to be one. A set is known by one of its members.
/// Cost: nearly constant.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : first_(count) {
    std::iota(first_.begin(), first_.end(), 0u);
  }

  /// The member by which i's set is known.
  std::uint32_t find(std::size_t i) {
    auto member = static_cast<std::uint32_t>(i);
    while (first_[member] != member) member = first_[member] = first_[first_[member]];
    return member;
  }
  /// Makes one of two sets; it is known by what `kept` was known by.
  void unite(std::uint32_t kept, std::uint32_t other) { first_[find(other)] = find(kept); }

 private:
  std::vector<std::uint32_t> first_;
};

}  // namespace thiessen
