#include "study/lost_digits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/number.h"
#include "base/utf8.h"
#include "geometry/box.h"
#include "geometry/shape_points.h"

namespace thiessen {
namespace {

struct Loss {
  double share = 0;
  double rounded_to = 0;
  double extent = 0;
  std::size_t basin = 0;
};

Box box_of(const Basin& basin) {
  Box box;
  every_point(basin.shape, [&](Point p) {
    box.take_in(p);
    return true;
  });
  return box;
}

/// Corners of cells closer than eight units in the last place of the largest coordinate are one
/// corner: see PlaneCentres.
Loss loss_in(const Box& box) {
  constexpr double told_apart = 8 * 0x1p-52;
  const double largest = std::max(
      {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  Loss loss;
  loss.rounded_to = told_apart * largest;
  loss.extent = std::max(box.width(), box.height());
  loss.share = loss.extent > 0 ? loss.rounded_to / loss.extent : 0;
  return loss;
}

}  // namespace

void judge_digits(const StudyParts& parts, Warnings& warnings) {
  if (parts.metric != Metric::planar) return;
  Loss worst;
  for (std::size_t i = 0; i < parts.basins.size(); ++i) {
    Loss loss = loss_in(box_of(parts.basins[i]));
    loss.basin = i;
    if (loss.share > worst.share) worst = loss;
  }
  if (worst.share <= share_lost_in_silence) return;
  const std::string where = "basin " + quoted(parts.basins[worst.basin].id, 80);
  const std::string what = "so far from the plane's origin positions are told apart to " +
                           significant_text(worst.rounded_to, 2) + ", and " + where + " is " +
                           significant_text(worst.extent, 2) + " across: ";
  const std::string& file = parts.has_basins ? parts.basins_file : parts.stations_file;
  const char* const hint =
      "take the same numbers off all coordinates of gauges and basins, so that they are near 0";
  if (worst.share <= share_lost_at_most) {
    warnings.add(
        {file, 0, what + "weights may be off by up to " + significant_text(worst.share, 2), hint});
    return;
  }
  throw Error(
      {file, 0,
       what + "weights would be off by up to " + significant_text(std::min(worst.share, 1.0), 2),
       hint});
}

}  // namespace thiessen
