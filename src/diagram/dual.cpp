#include "diagram/dual.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace thiessen {

void put_in_order(Dual& dual) {
  for (DualTriangle& triangle : dual.triangles) {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
  }
  std::sort(dual.triangles.begin(), dual.triangles.end());
  for (Border& border : dual.borders) {
    if (border.second < border.first) std::swap(border.first, border.second);
  }
  std::sort(dual.borders.begin(), dual.borders.end(), [](const Border& a, const Border& b) {
    return std::tie(a.first, a.second, a.length) < std::tie(b.first, b.second, b.length);
  });
  std::vector<Border> joined;
  joined.reserve(dual.borders.size());
  for (const Border& border : dual.borders) {
    const bool is_next_part = !joined.empty() && joined.back().first == border.first &&
                              joined.back().second == border.second;
    if (is_next_part) {
      joined.back().length += border.length;
    } else {
      joined.push_back(border);
    }
  }
  dual.borders = std::move(joined);
}

}  // namespace thiessen
