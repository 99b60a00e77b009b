#include "study/nearness.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "base/utf8.h"
#include "geometry/shape_points.h"
#include "study/coordinate_checks.h"
#include "study/gauge_spacing.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_id = 80;
constexpr std::size_t named_at_most = 5;

Box bounds_of(const Basin& basin) {
  Box box;
  for (const Polygon& polygon : basin.shape) {
    for (const Point p : polygon.outer) box.take_in(p);
  }
  return box;
}

void add_corners(const Box& box, std::vector<Point>& corners) {
  corners.insert(corners.end(),
                 {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}});
}

class NearnessJudge {
 public:
  NearnessJudge(const StudyParts& parts, const Network& network)
      : parts_(parts), network_(network), ruler_(parts) {
    for (const Basin& basin : parts.basins) {
      const Box box = bounds_of(basin);
      diagonals_.push_back(ruler_.diagonal(box));
      add_corners(box, basin_corners_);
    }
    // Which gauge it is matters only to basins that have none within their diagonal.
    nearest_ = nearest_gauges(network.places(), parts.basins, ruler_, diagonals_);
    gauges_ = ruler_.extent(network.places());
    add_corners(gauges_, gauge_corners_);
    for (const Point p : basin_corners_) basins_.take_in(p);
  }

  /// What is to be said where gauges and basins are nowhere near each other.
  std::optional<Message> far_apart() const {
    double least = std::numeric_limits<double>::infinity();
    for (const NearestGauge& nearest : nearest_) least = std::min(least, nearest.distance);
    const double diagonal = std::max(ruler_.diagonal(gauges_), ruler_.diagonal(basins_));
    if (least <= diagonals_apart_at_most * diagonal) return std::nullopt;
    if (ruler_.knows_metres() && least <= metres_apart_at_least) return std::nullopt;
    const auto text = [&](const std::string& in_file, const Box& box) {
      return in_file.empty() ? ruler_.text(box) : in_file;
    };
    Wording words = "gauges and basins are nowhere near each other, " + ruler_.text(least) +
                    " apart at least: gauges at " + text(parts_.gauges_extent, gauges_) +
                    "; basins at " + text(parts_.basins_extent, basins_);
    words += would_meet();
    return Message{parts_.stations_file, 0, words,
                   setting("allow_far") + " goes on where they are meant to be so far apart"};
  }

  void warn_of_far_basins(Warnings& warnings) const {
    std::vector<std::size_t> far;
    for (std::size_t b = 0; b < nearest_.size(); ++b) {
      if (nearest_[b].distance > diagonals_[b]) far.push_back(b);
    }
    if (far.empty()) return;
    const auto median = spacing_of(network_.places(), ruler_).median_edge;
    std::erase_if(far, [&](std::size_t b) {
      return nearest_[b].distance <= spacings_apart_at_most * median.value_or(diagonals_[b]);
    });
    if (far.empty()) return;
    std::string text;
    for (std::size_t i = 0; i < std::min(far.size(), named_at_most); ++i)
      text += (i == 0 ? "" : "; ") + nearest_text(far[i]);
    if (far.size() > named_at_most)
      text += "; and " + std::to_string(far.size() - named_at_most) + " more basins";
    if (median) text += ": neighbouring gauges are " + ruler_.text(*median) + " apart (the median)";
    Wording words = "far from all gauges: " + text;
    if (far.size() == nearest_.size() && !far_apart()) words += would_meet();
    warnings.add({parts_.basins_file, 0, words, ""});
  }

 private:
  std::string nearest_text(std::size_t b) const {
    const StationIndex station = network_.stations_at(nearest_[b].place).front();
    return "basin " + quoted(parts_.basins[b].id, longest_id) + " is " +
           ruler_.text(nearest_[b].distance) + " from the nearest, " +
           quoted(network_.stations()[index(station)].id, longest_id);
  }

  Wording would_meet() const {
    const Wording cause = likely_cause();
    return cause.empty() ? cause : "; they would meet with " + cause;
  }

  /// The mistake without which gauges and basins lie nearest to each other, if they would meet.
  Wording likely_cause() const {
    if (Wording units = other_units(); !units.empty()) return units;
    Wording likely;
    double least = std::numeric_limits<double>::infinity();
    const auto causes =
        parts_.far_causes ? parts_.far_causes() : far_causes_of_coordinates(ruler_.on_earth());
    for (const FarCause& cause : causes) {
      const auto apart = apart_without(cause);
      if (!apart || *apart >= least) continue;
      least = *apart;
      likely = cause.text;
    }
    return likely;
  }

  /// How far gauges and basins would be apart without a mistake, if they would meet.
  std::optional<double> apart_without(const FarCause& cause) const {
    const auto there = [](const FarCause::Correction& correct, std::vector<Point> points) {
      return correct ? correct(std::move(points)) : points;
    };
    const auto can_be = [&](Point p) {
      return is_finite(p) && (!ruler_.on_earth() || ruler_.can_be_latitude(p.y));
    };
    const std::vector<Point> gauges = there(cause.gauges, gauge_corners_);
    const std::vector<Point> corners = there(cause.basins, basin_corners_);
    if (!std::all_of(gauges.begin(), gauges.end(), can_be)) return std::nullopt;
    if (!std::all_of(corners.begin(), corners.end(), can_be)) return std::nullopt;
    const Box of_gauges = ruler_.extent(gauges);
    const Box of_basins = ruler_.extent(corners);
    const double apart = ruler_.between(of_gauges, of_basins);
    if (apart > std::max(ruler_.diagonal(of_gauges), ruler_.diagonal(of_basins)))
      return std::nullopt;
    return apart;
  }

  /// Words that one of the two is in degrees, where no CRS is known and only one can be.
  Wording other_units() const {
    if (ruler_.on_earth() || parts_.far_causes) return {};
    Reach of_gauges;
    Reach of_basins;
    for (const Point p : network_.places()) of_gauges.see(p);
    for (const Point p : basin_corners_) of_basins.see(p);
    if ((of_gauges.not_degrees == 0) == (of_basins.not_degrees == 0)) return {};
    if (of_gauges.not_degrees > 0 && of_gauges.not_degrees < of_gauges.points) return {};
    if (of_basins.not_degrees > 0 && of_basins.not_degrees < of_basins.points) return {};
    const bool gauges = of_gauges.not_degrees == 0;
    return std::string("their CRSs named, for only the ") + (gauges ? "gauges" : "basins") +
           " can be in degrees: " + setting("crs") + ", " + setting("basins_crs");
  }

  const StudyParts& parts_;
  const Network& network_;
  Ruler ruler_;
  std::vector<NearestGauge> nearest_;
  std::vector<double> diagonals_;  // by basin
  std::vector<Point> gauge_corners_;
  std::vector<Point> basin_corners_;  // of each basin's box
  Box gauges_;
  Box basins_;
};

}  // namespace

void judge_nearness(const StudyParts& parts, const Network& network, bool allow_far,
                    Warnings& warnings) {
  NearnessJudge judge(parts, network);
  if (auto far = judge.far_apart()) {
    if (!allow_far) throw Error(*std::move(far));
    far->hint = {};
    warnings.add(*std::move(far));
  }
  judge.warn_of_far_basins(warnings);
}

}  // namespace thiessen
