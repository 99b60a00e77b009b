#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "basin/cell_clipper.h"
#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// The shares of cells in a basin, and what a field of normals measures of their ground.
struct MeasuredShares {
  std::vector<CellShare> shares;
  std::vector<double> figures;  ///< share by share; none where the field is uniform

  std::span<const double> figures_of(std::size_t share) const {
    const std::size_t count = shares.empty() ? 0 : figures.size() / shares.size();
    return std::span(figures).subspan(share * count, count);
  }
};

/// The mean normal over the ground of each share. Ground of which a part has no normals has the
/// mean of the rest of it, and ground without any that of the basin.
std::vector<double> mean_normals(const NormalField& normals, std::size_t basin,
                                 const MeasuredShares& ground, const NormalMonth& month);

}  // namespace thiessen
