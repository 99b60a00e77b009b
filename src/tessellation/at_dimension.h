#pragma once

#include <type_traits>

namespace thiessen {

/// Calls `work` with the dimension that the points span as a compile-time number, so that run-time
/// code can choose a template. Requires a dimension from 1 to Dimension.
template <int Dimension, typename Work>
decltype(auto) at_dimension(int dimension, Work&& work) {
  if constexpr (Dimension == 3) {
    if (dimension == 3) return work(std::integral_constant<int, 3>{});
  }
  if (dimension == 2) return work(std::integral_constant<int, 2>{});
  return work(std::integral_constant<int, 1>{});
}

}  // namespace thiessen
