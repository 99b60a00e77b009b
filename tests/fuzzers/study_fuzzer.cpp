#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "earth/sphere/geodesic.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/message_laws.h"
#include "oracles/half_planes.h"
#include "study/thiessen.h"

namespace thiessen::fuzzers {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double silent = std::numeric_limits<double>::quiet_NaN();

/// A study of few gauges on a coarse lattice, so that ties, lines and shared places are common, now
/// and then a little beside it.
class StudyOf {
 public:
  explicit StudyOf(Bytes& bytes) : bytes_(bytes) {}

  ThiessenInput make() {
    input_.metric = bytes_.below(3) == 0 ? Metric::geodesic : Metric::planar;
    input_.mend = bytes_.below(2) == 0;
    input_.allow_far = true;
    if (on_earth()) {
      constexpr double spacings[] = {1e-3, 0.02, 0.5, 4};
      spacing_ = bytes_.one_of(spacings);
      origin_ = {static_cast<double>(bytes_.below(36)) * 10 - 180,
                 static_cast<double>(bytes_.below(17)) * 10 - 80};
    }
    const std::size_t gauges = 1 + bytes_.below(12);
    for (std::size_t i = 0; i < gauges; ++i)
      input_.stations.push_back({"g" + std::to_string(i), place(), 0});
    if (bytes_.below(8) == 0 && !on_earth()) input_.stations[0].id = bytes_.until('\xFE');
    const std::size_t basins = 1 + bytes_.below(2);
    for (std::size_t i = 0; i < basins; ++i)
      input_.basins.push_back({"b" + std::to_string(i), {{ring(), {}}}, {}});
    return std::move(input_);
  }

 private:
  bool on_earth() const { return input_.metric == Metric::geodesic; }
  double shifted(std::size_t step) {
    const double fine = bytes_.below(4) == 0 ? static_cast<double>(bytes_.next()) / 256 : 0;
    return spacing_ * (static_cast<double>(step) + fine);
  }
  Point place() {
    const double x = shifted(bytes_.below(8));
    const double y = shifted(bytes_.below(8));
    return {origin_.x + x, std::clamp(origin_.y + y, -90.0, 90.0)};
  }
  /// A star round a centre, or any ring at all.
  Ring ring() {
    const std::size_t corners = 3 + bytes_.below(6);
    Ring ring;
    if (bytes_.below(4) == 0) {
      for (std::size_t i = 0; i < corners; ++i) ring.push_back(place());
      return ring;
    }
    const Point centre = place();
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(corners);
      const double reach = spacing_ * static_cast<double>(1 + bytes_.below(24)) / 4;
      ring.push_back({centre.x + reach * std::cos(angle),
                      std::clamp(centre.y + reach * std::sin(angle), -90.0, 90.0)});
    }
    return ring;
  }

  Bytes& bytes_;
  ThiessenInput input_;
  double spacing_ = 1;
  Point origin_{0, 0};
};

/// Twice the signed area of what is left of a ring when all bisectors of places[i] have cut it. The
/// ring need not be convex: the bridges that cutting leaves enclose nothing.
long double brute_area(const Ring& ring, std::span<const Point> places, std::size_t i) {
  std::vector<half_planes::LongPoint> left;
  for (const Point p : ring) left.push_back({p.x, p.y});
  for (std::size_t j = 0; j < places.size() && !left.empty(); ++j) {
    if (j != i) left = half_planes::kept_part(left, half_planes::Bisector{places[i], places[j]});
  }
  long double twice = 0;
  for (std::size_t p = 0; p < left.size(); ++p) {
    const auto& a = left[p];
    const auto& b = left[(p + 1) % left.size()];
    twice += (a.x - left[0].x) * (b.y - left[0].y) - (b.x - left[0].x) * (a.y - left[0].y);
  }
  return twice / 2;
}

/// Requires of weights that they add up, and in a plane that each is the area that brute force
/// leaves. `reports` tells which gauges there are.
void require_areas(const Thiessen& study, const std::vector<BasinWeights>& weights,
                   const std::vector<bool>& reports, bool planar) {
  std::vector<Point> places;
  std::vector<std::size_t> sharing;
  for (std::size_t s = 0; s < reports.size(); ++s) {
    if (!reports[s]) continue;
    const Point at = study.stations()[s].position;
    const auto number =
        static_cast<std::size_t>(std::find(places.begin(), places.end(), at) - places.begin());
    if (number == places.size()) places.push_back(at);
    sharing.resize(places.size());
    ++sharing[number];
  }
  for (std::size_t b = 0; b < weights.size(); ++b) {
    double sum = 0;
    for (const StationWeight& gauge : weights[b].stations) {
      require(gauge.weight > 0 && gauge.weight <= 1 + 1e-12, "a weight that is none");
      sum += gauge.weight;
    }
    // Areas on the Earth are right to less than a square millimetre, which tiny basins see.
    const double allowed = planar ? 1e-12 : 1e-9 + 1e-6 / weights[b].area;
    require(places.empty() || std::abs(sum - 1) < allowed,
            "weights that add up to 1 and " + std::to_string(1e12 * (sum - 1)) + "e-12");
    if (!planar || places.empty()) continue;
    for (const StationWeight& gauge : weights[b].stations) {
      const Point at = study.stations()[index(gauge.station)].position;
      const auto place =
          static_cast<std::size_t>(std::find(places.begin(), places.end(), at) - places.begin());
      long double area = 0;
      for (const Polygon& part : study.basins()[b].shape) {
        area += brute_area(part.outer, places, place);
        for (const Ring& hole : part.holes) area += brute_area(hole, places, place);
      }
      area /= static_cast<long double>(sharing[place]);
      require(std::abs(static_cast<double>(area) - gauge.area) <= 1e-9 * weights[b].area,
              "an area that brute force has otherwise");
    }
  }
}

/// Requires weights of those that report to be those of a study that has no others.
void require_same_as_alone(const Thiessen& study, const ThiessenInput& input,
                           const std::vector<bool>& reports,
                           const std::vector<BasinWeights>& weights) {
  ThiessenInput others = input;
  others.stations.clear();
  std::vector<std::size_t> kept;
  for (std::size_t s = 0; s < reports.size(); ++s) {
    if (!reports[s]) continue;
    others.stations.push_back(input.stations[s]);
    kept.push_back(s);
  }
  if (kept.empty()) return;
  const Thiessen alone(others);
  const double allowed = input.metric == Metric::planar ? 1e-12 : 1e-7;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    std::vector<double> found(study.stations().size(), 0);
    for (const StationWeight& gauge : weights[b].stations)
      found[index(gauge.station)] = gauge.weight;
    for (const StationWeight& gauge : alone.weights()[b].stations)
      found[kept[index(gauge.station)]] -= gauge.weight;
    for (const double difference : found)
      require(std::abs(difference) <= allowed,
              "weights that differ from a study without the silent");
  }
}

/// Requires rainfall with silent gauges, by handovers, to be that of the weights of the others.
void require_rainfall(const Thiessen& study, const std::vector<bool>& reports,
                      const std::vector<BasinWeights>& weights, bool planar) {
  std::vector<double> readings(reports.size(), silent);
  for (std::size_t s = 0; s < reports.size(); ++s) {
    if (reports[s]) readings[s] = static_cast<double>(1 + s * s % 7);
  }
  const std::vector<BasinRainfall> rainfall = study.rainfall(readings);
  for (std::size_t b = 0; b < weights.size(); ++b) {
    double sum = 0;
    for (const StationWeight& gauge : weights[b].stations)
      sum += gauge.weight * readings[index(gauge.station)];
    if (weights[b].stations.empty()) {
      require(std::isnan(rainfall[b].rainfall), "rainfall of nobody");
    } else {
      // Vertices between heirs are right to a millimetre, which small basins see.
      const double share = planar ? 1e-11 : 1e-7 + 0.01 / std::sqrt(weights[b].area);
      require(std::abs(rainfall[b].rainfall - sum) <= 7 * share,
              "handovers that differ from the tessellation of the others: " +
                  std::to_string(rainfall[b].rainfall) + " and not " + std::to_string(sum));
    }
  }
}

bool is_within(const MultiPolygon& shape, Point p) {
  bool within = false;
  const auto ring = [&](const Ring& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point a = points[i];
      const Point b = points[(i + 1) % points.size()];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) within = !within;
    }
  };
  for (const Polygon& part : shape) {
    ring(part.outer);
    for (const Ring& hole : part.holes) ring(hole);
  }
  return within;
}

/// Requires of points on the Earth that lie in a cell that its gauge is the nearest one, to twice
/// the tolerance.
void require_nearest(const Thiessen& study, Bytes& bytes) {
  const auto cells = study.cells();
  for (std::size_t b = 0; b < cells.size(); ++b) {
    for (const StationCell& cell : cells[b]) {
      const Ring& ring = cell.shape.at(0).outer;
      const Point from = ring[bytes.next() % ring.size()];
      const Point to = ring[(bytes.next() + ring.size() / 2) % ring.size()];
      const double along = (1 + static_cast<double>(bytes.next())) / 257;
      const Point p{from.x + along * (to.x - from.x), from.y + along * (to.y - from.y)};
      if (!is_within(cell.shape, p)) continue;
      const double own = geodesic_distance(study.stations()[index(cell.station)].position, p);
      for (const Station& other : study.stations())
        require(own <= geodesic_distance(other.position, p) + 0.2, "a cell of another's ground");
    }
  }
}

}  // namespace

void fuzz_study(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  const ThiessenInput given = StudyOf(bytes).make();
  try {
    const Thiessen study(given);
    const bool planar = given.metric == Metric::planar;
    std::vector<bool> reports(given.stations.size(), true);
    require_areas(study, study.weights(), reports, planar);
    if (!planar) require_nearest(study, bytes);
    for (std::size_t s = 0; s < reports.size(); ++s) reports[s] = bytes.below(2) == 0;
    const std::vector<BasinWeights> weights = study.weights(reports);
    require_areas(study, weights, reports, planar);
    require_rainfall(study, reports, weights, planar);
    require_same_as_alone(study, given, reports, weights);
  } catch (const Error& error) {
    require_sentences(error);
  }
}

}  // namespace thiessen::fuzzers
