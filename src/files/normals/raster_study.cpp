#include "files/normals/raster_study.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "base/number.h"
#include "base/utf8.h"
#include "files/normals/raster_ground.h"
#include "rainfall/normals/raster_normals.h"

namespace thiessen {
namespace {

bool is_good(double normal) {
  return std::isfinite(normal) && normal > 0;
}

void settle_bands(const RasterSource& source, Warnings& warnings) {
  if (source.bands() == 12) {
    warnings.add_notice({source.file(), 0,
                         "its twelve bands are taken to be the months from January to December",
                         ""});
  }
  if (source.bands() == 1 || source.bands() == 12) return;
  throw Error({source.file(), 0,
               "has " + std::to_string(source.bands()) +
                   " bands, and normals have one, or twelve for the calendar months",
               "gdal_translate -b N makes a raster of one"});
}

void complain_of_gauge(const std::string& file, const Station& station,
                       const std::vector<double>& normals, bool is_within, Complaints& complaints) {
  const auto bad = std::find_if_not(normals.begin(), normals.end(), is_good);
  if (bad == normals.end()) return;
  const std::string in_month =
      normals.size() == 1 ? "" : " in month " + std::to_string(bad - normals.begin() + 1);
  const std::string what = !is_within         ? "lies outside of the raster"
                           : std::isnan(*bad) ? "has no normal" + in_month
                                              : "has the normal " + shortest_text(*bad) + in_month +
                                                    ", and normals are above 0";
  complaints.add({file, 0, "station " + quoted(station.id, 80) + " " + what,
                  setting("stations_where") + " leaves stations out of the network"});
}

/// Complains of values in a basin that are not above 0.
void complain_of_values(const RasterGround& ground, std::size_t basin, const RasterFrame& frame,
                        const WindowValues& values, Complaints& complaints) {
  if (values.least() > 0 && std::isfinite(values.largest())) return;
  std::optional<WindowValues> bad;
  for (std::size_t band = 0; band < values.bands(); ++band) {
    for (std::size_t r = 0; r < values.rows(); ++r) {
      for (std::size_t c = 0; c < values.columns(); ++c) {
        const double value = values.at(band, r, c);
        if (std::isnan(value) || is_good(value)) continue;
        if (!bad) bad.emplace(values.columns(), values.rows(), 1, false);
        if (std::isnan(bad->at(0, r, c))) bad->set(0, r, c, 1);
      }
    }
  }
  if (!bad) return;
  const double share = ground.share_of(basin, frame, std::move(*bad));
  if (share == 0) return;
  complaints.add({ground.source().file(), 0,
                  "has normals that are not above 0 on " + percent_of_ground(share) + " of " +
                      ground.place_of(basin),
                  "gdal_translate -a_nodata takes such a value for none"});
}

}  // namespace

std::shared_ptr<const NormalField> normals_of_raster(const std::string& file, const Study& study,
                                                     const StudyFiles& files, Warnings& warnings) {
  const RasterGround ground(file, study, files, warnings);
  settle_bands(ground.source(), warnings);
  const std::vector<std::optional<RasterPart>> pixels = ground.pixels_of_stations();
  std::vector<std::vector<double>> gauges;
  Complaints complaints;
  for (std::size_t s = 0; s < pixels.size(); ++s) {
    gauges.push_back(ground.at_pixel(pixels[s]));
    complain_of_gauge(file, study.network().stations()[s], gauges[s], pixels[s].has_value(),
                      complaints);
  }
  complaints.throw_if_any();
  const std::vector<double> references = gauges.front();
  std::vector<NormalWindow> windows;
  std::vector<double> areas;
  for (std::size_t b = 0; b < study.basins().size(); ++b) {
    throw_if_interrupted();
    areas.push_back(study.weighing().basin_area(b));
    const std::optional<RasterFrame> frame = ground.frame_of(b, complaints);
    if (!frame) continue;
    WindowValues values = ground.values_of(*frame);
    complain_of_values(ground, b, *frame, values, complaints);
    windows.push_back(ground.window(b, *frame, std::move(values), references));
  }
  complaints.throw_if_any();
  auto normals = std::make_shared<const RasterNormals>(std::move(gauges), std::move(windows),
                                                       study.basins(), areas);
  ground.judge_cover(*normals, "normals", warnings);
  return normals;
}

}  // namespace thiessen
