#pragma once

#include <memory>
#include <vector>

#include "base/error.h"
#include "files/normals/raster_ground.h"
#include "files/study_files.h"
#include "rainfall/normals/elevation_fit.h"
#include "rainfall/normals/normal_field.h"
#include "study/study.h"

namespace thiessen {

/// The normals that a fit by elevation tells over a study's basins.
struct FittedGround {
  std::shared_ptr<const NormalField> normals;
  /// The variance of ln N of each basin's mean normal, month by month: the mean of the kriging
  /// variance over points of the basin, which is no less than the variance of the mean.
  std::vector<std::vector<double>> log_variances;
};

/// The normals of the ground whose elevations a raster has, pixel by pixel: see ElevationLattice,
/// whose nodes are a third of the gauges' spacing apart, or a pixel where that is more. Where a
/// basin has more than 128 pixels along a side, blocks of them that are small beside that stand for
/// them, by the mean and the variance of their elevations. The
/// raster's values are multiplied by `scale`. Says on which share of the worst basin normals are
/// held by the nearest gauge's. Warns of basins that the raster does not cover whole, and throws
/// Error where it has none of one.
FittedGround normals_of_elevations(const ElevationFit& fit, const RasterGround& ground,
                                   double scale, const Study& study, unsigned threads,
                                   Warnings& warnings);

/// The same for basins of which only the mean elevation is known, which StudyFiles has: the mean
/// over points of the basin at that elevation. Throws Error, naming each basin without one.
FittedGround normals_of_mean_elevations(const ElevationFit& fit, const Study& study,
                                        const StudyFiles& files, unsigned threads,
                                        Warnings& warnings);

}  // namespace thiessen
