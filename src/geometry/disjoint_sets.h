#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace thiessen {

/// A union-find structure: numbered things, some of which turn out to be one. One member of each
/// set stands for the set. Cost: nearly constant for each call.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : first_(count) {
    std::iota(first_.begin(), first_.end(), 0u);
  }

  /// The member that stands for i's set.
  std::uint32_t find(std::size_t i) {
    auto member = static_cast<std::uint32_t>(i);
    while (first_[member] != member) member = first_[member] = first_[first_[member]];
    return member;
  }
  /// Unites the sets of two things. The member that stood for the set of `kept` stands for the
  /// union.
  void unite(std::uint32_t kept, std::uint32_t other) { first_[find(other)] = find(kept); }

 private:
  std::vector<std::uint32_t> first_;
};

}  // namespace thiessen
