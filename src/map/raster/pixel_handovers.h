#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "earth/nearest/nearest_places.h"
#include "earth/nearest/place_tree.h"
#include "geometry/pixel_grid.h"
#include "geometry/point_mapping.h"
#include "map/raster/place_runs.h"
#include "rainfall/network/network.h"
#include "rainfall/network/reporting.h"

namespace thiessen {

/// Pixels, and the place that owns them instead of a silent one.
struct HandedRun {
  PixelRun pixels;
  PlaceIndex owner;
};

/// Tells who owns a silent place's pixels in its stead.
///
/// Let the pixels go to their nearest places but for some that are absent. Where all of these
/// winners report, nothing is nearer, whoever else is silent; where one is silent, it is absent
/// too, and the question is asked again. So what is found depends on the few places that were
/// absent, and is remembered by them.
///
/// The winners lie no farther from the silent place than twice the radius of its cell and the
/// distance to the nearest place that is not absent. Only those places are asked, on the pixels of
/// the cell's box, by Owners; so a pixel's owner is exactly that of a raster of the gauges that
/// report, where equally near places count in the order of their first stations.
class PixelHandovers {
 public:
  /// `runs` are those of the network whose places report. The arguments must outlive this object.
  PixelHandovers(const PixelGrid& grid, const Network& network, Metric metric,
                 const PlaceRuns& runs, std::function<PointMapping()> to_study, unsigned threads);

  /// The pixels of a silent place with their owners; none where no place reports. The span lasts
  /// until the place is asked for again or forgotten. Several threads may ask at once for different
  /// places, each under a number of its own, below the number of threads.
  std::span<const HandedRun> of(std::size_t worker, PlaceIndex silent,
                                const ReportingPlaces& reports);

  /// Forgets what is remembered if it takes more memory than that. No thread may ask meanwhile.
  void forget_beyond(std::size_t bytes);

 private:
  using Absent = std::vector<PlaceIndex>;
  struct Handover {
    std::vector<HandedRun> runs;
    std::vector<PlaceIndex> winners;  ///< in rising order
  };
  struct Cell {
    double radius = -1;  ///< in space, from the place to the centres of its pixels
    PixelBlock box;
    std::map<Absent, Handover> by_absent;
    Handover last;  ///< one that is not worth remembering
  };

  PixelBlock box_of(PlaceIndex place) const;
  double radius_of(std::size_t worker, PlaceIndex place);
  std::vector<PlaceIndex> rivals_of(PlaceIndex place, double radius,
                                    const std::function<bool(PlaceIndex)>& is_absent) const;
  Handover hand_over(std::size_t worker, PlaceIndex place,
                     const std::function<bool(PlaceIndex)>& is_absent);
  const PointMapping& mapping_of(std::size_t worker);

  const PixelGrid& grid_;
  const Network& network_;
  Metric metric_;
  const PlaceRuns& runs_;
  std::function<PointMapping()> to_study_;
  std::unique_ptr<const NearestPlaces> nearest_;
  PlaceTree tree_;
  std::vector<Cell> cells_;             // by place
  std::vector<PointMapping> mappings_;  // by worker
  std::atomic<std::size_t> bytes_ = 0;  // that handovers take, about
};

}  // namespace thiessen
