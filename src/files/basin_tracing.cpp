#include "files/basin_tracing.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "outlines/disputed_ground.h"
#include "outlines/polygon_validity.h"
#include "outlines/sliver_collapse.h"

namespace thiessen {
namespace {

constexpr double chords = 0.25;  // of the tolerance
/// How a basin is tried again that crosses itself: what narrower needles, in metres, are collapsed,
/// and how near chords then follow the edges, in metres. The first is more than coordinates in
/// longitude and latitude are rounded by (3e-9); the last shows in no area.
struct Attempt {
  double needles;
  double chord_error;
};
constexpr double as_before = 1e9;
constexpr std::array<Attempt, 7> attempts = {{{1e-7, as_before},
                                              {1e-7, 1e-3},
                                              {1e-5, as_before},
                                              {1e-5, 1e-3},
                                              {1e-5, 1e-6},
                                              {1e-3, as_before},
                                              {1e-3, 1e-6}}};

/// About so many units of the CRS are a metre.
double units_per_metre(const Crs& crs) {
  constexpr double metres_per_degree = 111320;
  return crs.geographic() ? 1 / (metres_per_degree * crs.degrees_per_unit())
                          : 1 / crs.metres_per_unit();
}

bool are_same(const Polygon& one, const Polygon& other) {
  return one.outer == other.outer && one.holes == other.holes;
}

/// The basin without what is narrower than the grid; nothing where that is the basin as it is, or
/// where nothing were left.
std::optional<MultiPolygon> without_needles(const MultiPolygon& basin, double grid) {
  auto result = collapsed(std::span(&basin, 1), grid);
  if (!result || result->front().empty()) return std::nullopt;
  if (std::ranges::equal(result->front(), basin, are_same)) return std::nullopt;
  return std::move(result->front());
}

}  // namespace

BasinTracing::BasinTracing(const Crs& from, const Crs& to, double tolerance)
    : from_(from),
      to_(to),
      tolerance_(tolerance),
      tracer_(tracer_between(from, to, chords * tolerance, Course::chords_and_bulges)) {}

std::optional<CurvedShape> BasinTracing::trace_with(ShapeTracer& tracer,
                                                    const MultiPolygon& basin) {
  auto traced = tracer.trace(basin, Longitudes::run_on);
  if (!traced) outside_ = tracer.outside();
  fault_ = traced ? validity_fault(traced->shape) : "";
  return traced;
}

std::optional<CurvedShape> BasinTracing::trace(MultiPolygon& basin) {
  collapsed_ = 0;
  auto traced = trace_with(tracer_, basin);
  if (!traced || fault_.empty()) return traced;
  const MultiPolygon whole = basin;
  for (const Attempt& attempt : attempts) {
    auto rest = without_needles(whole, attempt.needles * units_per_metre(from_));
    const bool loses = rest.has_value();
    basin = loses ? *std::move(rest) : whole;
    const double chord_error = std::min(attempt.chord_error, chords * tolerance_);
    ShapeTracer tracer = tracer_between(from_, to_, chord_error, Course::chords_and_bulges);
    traced = trace_with(tracer, basin);
    if (traced && !fault_.empty()) continue;
    if (loses) collapsed_ = attempt.needles;
    return traced;
  }
  return std::nullopt;
}

PlaneMending make_valid_in_plane(MultiPolygon& shape) {
  std::string fault = validity_fault(shape);
  if (fault.empty()) return {};
  constexpr double nearly_same_area = 1e-5;
  Ground ground = ground_of(shape);
  if (!(ground.area > 0) || ground.disputed_area > nearly_same_area * ground.area)
    return {false, std::move(fault)};
  shape = std::move(ground.shape);
  return {true, {}};
}

}  // namespace thiessen
