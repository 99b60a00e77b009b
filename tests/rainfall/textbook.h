#pragma once

#include <string>
#include <vector>

#include "basin/basin.h"
#include "rainfall/network/network.h"

namespace thiessen::textbook {

/// V. T. Chow, D. R. Maidment, L. W. Mays, Applied hydrology, 1988, problem 3.4.5.
inline std::vector<Station> stations() {
  return {{"1", {7, 4}, 2},   {"2", {3, 4}, 3},   {"3", {-2, 5}, 4},
          {"4", {-10, 1}, 5}, {"5", {-3, -3}, 6}, {"6", {-7, -7}, 7},
          {"7", {2, -3}, 8},  {"8", {2, -10}, 9}, {"9", {0, 0}, 10}};
}

inline std::vector<double> readings() {
  return {62, 59, 41, 39, 105, 98, 60, 41, 81};
}

inline Basin basin() {
  return {"basin", {{{{5, 5}, {-5, 5}, {-5, -5}, {0, -10}, {5, -5}}, {}}}, {}};
}

}  // namespace thiessen::textbook
