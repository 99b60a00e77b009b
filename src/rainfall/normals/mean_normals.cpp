#include "rainfall/normals/mean_normals.h"

#include <cmath>

namespace thiessen {

std::vector<double> mean_normals(const NormalField& normals, std::size_t basin,
                                 const MeasuredShares& ground, const NormalMonth& month) {
  std::vector<double> means;
  means.reserve(ground.shares.size());
  for (std::size_t i = 0; i < ground.shares.size(); ++i) {
    const double area = ground.shares[i].area;
    const GroundNormal normal = normal_over(normals, basin, ground.figures_of(i), area, month);
    means.push_back(std::isnan(normal.mean) ? basin_normal(normals, basin, month) : normal.mean);
  }
  return means;
}

}  // namespace thiessen
