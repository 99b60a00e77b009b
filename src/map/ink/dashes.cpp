#include "map/ink/dashes.h"

#include <algorithm>
#include <cmath>

namespace thiessen {

std::vector<Dash> dashes(double length, double dash, double gap) {
  if (length <= gap) return {{0, length}};
  const double gaps = std::max(1.0, std::round((length - dash) / (dash + gap)));
  const double stretch = length / (gaps * (dash + gap) + dash);
  std::vector<Dash> result;
  for (double i = 0; i <= gaps; ++i) {
    const double from = i * (dash + gap) * stretch;
    result.push_back({from, i == gaps ? length : from + dash * stretch});
  }
  return result;
}

}  // namespace thiessen
