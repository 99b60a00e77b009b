#include "io/basin_mending.h"

#include <ogr_geometry.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "io/gdal_errors.h"
#include "io/geometry_conversion.h"
#include "io/ring_direction.h"

namespace thiessen {
namespace {

constexpr double same_area = 1e-9;

/// What was mended in a basin.
struct Mended {
  std::size_t repeated = 0;
  std::size_t spikes = 0;
  std::size_t open = 0;
  std::size_t parts = 0;
  std::size_t holes = 0;
  bool redrawn = false;

  bool any() const { return repeated + spikes + open + parts + holes > 0 || redrawn; }
};

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string sentence(const Mended& mended, const std::string& reason) {
  std::vector<std::string> what;
  if (mended.repeated > 0)
    what.push_back(counted(mended.repeated, "repeated point", "repeated points"));
  if (mended.spikes > 0) what.push_back(counted(mended.spikes, "spike", "spikes"));
  if (mended.open > 0) what.push_back(counted(mended.open, "open ring", "open rings"));
  if (mended.parts > 0)
    what.push_back(counted(mended.parts, "part without area", "parts without area"));
  if (mended.holes > 0)
    what.push_back(counted(mended.holes, "hole without area", "holes without area"));
  if (mended.redrawn) what.push_back("where it meets itself (" + reason + ")");
  std::string text;
  for (std::size_t i = 0; i < what.size(); ++i) text += (i == 0 ? "" : ", ") + what[i];
  return text;
}

/// Adds a point to a ring that never doubles back: a point, its return and the spike between are
/// gone.
void append(Ring& ring, Point point, Mended& mended) {
  if (!ring.empty() && ring.back() == point) {
    ++mended.repeated;
  } else if (ring.size() > 1 && ring[ring.size() - 2] == point) {
    ring.pop_back();
    ++mended.spikes;
  } else {
    ring.push_back(point);
  }
}

/// The same over the ring's seam.
void trim_seam(Ring& ring, Mended& mended) {
  std::size_t first = 0;
  while (ring.size() - first > 2) {
    if (ring.back() == ring[first]) {
      ring.pop_back();
      ++mended.repeated;
    } else if (ring[ring.size() - 2] == ring[first]) {
      ring.resize(ring.size() - 2);
      ++mended.spikes;
    } else if (ring.back() == ring[first + 1]) {
      ++first;
      ring.pop_back();
      ++mended.spikes;
    } else {
      break;
    }
  }
  ring.erase(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first));
}

Ring cleaned(const Ring& raw, Mended& mended) {
  Ring ring;
  ring.reserve(raw.size());
  std::size_t length = raw.size();
  if (length > 1 && raw.front() == raw.back()) {
    --length;
  } else {
    ++mended.open;
  }
  for (std::size_t i = 0; i < length; ++i) append(ring, raw[i], mended);
  trim_seam(ring, mended);
  return ring;
}

MultiPolygon cleaned(const MultiPolygon& raw, Mended& mended) {
  MultiPolygon shape;
  for (const Polygon& part : raw) {
    Polygon polygon;
    polygon.outer = cleaned(part.outer, mended);
    for (const Ring& hole : part.holes) {
      Ring ring = cleaned(hole, mended);
      if (ring.size() > 2) {
        polygon.holes.push_back(std::move(ring));
      } else {
        ++mended.holes;
      }
    }
    if (polygon.outer.size() > 2 || !polygon.holes.empty()) {
      shape.push_back(std::move(polygon));
    } else {
      ++mended.parts;
    }
  }
  return shape;
}

double area(const MultiPolygon& shape) {
  double sum = 0;
  for (const Polygon& polygon : shape) {
    sum += std::abs(signed_area(polygon.outer));
    for (const Ring& hole : polygon.holes) sum -= std::abs(signed_area(hole));
  }
  return sum;
}

/// Empty where the shape is valid, else what GEOS finds wrong and where.
std::string fault_of(const MultiPolygon& shape) {
  const auto geometry = ogr_shape(shape);
  const GdalErrors errors;
  if (geometry->IsValid() != FALSE) return {};
  std::string reason = errors.text();
  for (char& c : reason) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return reason;
}

/// GEOS's two ways to a valid shape: `LINEWORK` is the even-odd rule for a single ring; `STRUCTURE`
/// is the union of the shells less the union of the holes.
MultiPolygon made_valid(const MultiPolygon& shape, const char* method) {
  const std::string option = std::string("METHOD=") + method;
  const char* options[] = {option.c_str(), nullptr};
  const auto geometry = ogr_shape(shape);
  const GdalErrors errors;
  const std::unique_ptr<OGRGeometry> valid(geometry->MakeValid(options));
  return valid ? polygons_of(*valid) : MultiPolygon{};
}

/// Whether a union covers as much as its rings together: then none of them overlap.
bool disjoint(const MultiPolygon& rings, double tolerance) {
  return fault_of(rings).empty() ||
         std::abs(area(made_valid(rings, "STRUCTURE")) - area(rings)) <= tolerance;
}

/// Whether a ring goes round each of its points once, and never the other way.
bool simple(const Polygon& ring, double tolerance) {
  const MultiPolygon one = {ring};
  return fault_of(one).empty() ||
         (std::abs(area(made_valid(one, "LINEWORK")) - area(one)) <= tolerance &&
          std::abs(area(made_valid(one, "STRUCTURE")) - area(one)) <= tolerance);
}

/// Whether the winding number is 0 or 1 wherever it covers an area: each ring is simple, shells do
/// not overlap and nor do holes, and (by the area of the whole) holes lie within shells.
bool winds_once(const MultiPolygon& shape, double tolerance) {
  MultiPolygon shells;
  MultiPolygon holes;
  for (const Polygon& polygon : shape) {
    shells.push_back({polygon.outer, {}});
    for (const Ring& hole : polygon.holes) holes.push_back({hole, {}});
  }
  const auto is_simple = [&](const Polygon& ring) { return simple(ring, tolerance); };
  return std::all_of(shells.begin(), shells.end(), is_simple) &&
         std::all_of(holes.begin(), holes.end(), is_simple) &&
         (shells.size() < 2 || disjoint(shells, tolerance)) &&
         (holes.size() < 2 || disjoint(holes, tolerance));
}

}  // namespace

std::optional<MultiPolygon> mend(const RawBasin& basin, const std::string& file, Warnings& warnings,
                                 Complaints& complaints) {
  const auto refuse = [&](const std::string& text) {
    complaints.add({file, basin.line, basin.place + " " + text, {}});
    return std::nullopt;
  };
  Mended mended;
  MultiPolygon shape = cleaned(basin.polygons, mended);
  if (shape.empty()) return refuse("has no area");
  const std::string fault = fault_of(shape);
  if (!fault.empty()) {
    MultiPolygon redrawn = made_valid(shape, "STRUCTURE");
    const double whole = area(redrawn);
    const double tolerance = same_area * whole;
    if (!(whole > 0)) return refuse("has no area: " + fault);
    if (std::abs(whole - area(shape)) > tolerance || !winds_once(shape, tolerance)) {
      return refuse("crosses or overlaps itself: " + fault);
    }
    shape = std::move(redrawn);
    mended.redrawn = true;
  }
  turn_rings(shape);
  if (mended.any()) {
    warnings.add({file, basin.line, basin.place + " is mended: " + sentence(mended, fault), {}});
  }
  return shape;
}

}  // namespace thiessen
