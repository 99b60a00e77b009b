#pragma once

#include <string_view>

#include "base/number.h"
#include "geometry/polygon.h"

namespace thiessen {

/// The polygons of a well-formed WKT of a POLYGON or MULTIPOLYGON in the plane, rings as written.
class WktShape {
 public:
  explicit WktShape(std::string_view wkt) : rest_(wkt) {}

  MultiPolygon read() {
    const bool several = rest_.starts_with("MULTI");
    rest_.remove_prefix(rest_.find('('));
    MultiPolygon shape;
    if (!several) {
      shape.push_back(polygon());
      return shape;
    }
    do {
      rest_.remove_prefix(1);
      shape.push_back(polygon());
    } while (rest_.starts_with(','));
    return shape;
  }

 private:
  Polygon polygon() {
    Polygon polygon;
    rest_.remove_prefix(rest_.find('(') + 1);
    polygon.outer = ring();
    while (rest_.starts_with(',')) polygon.holes.push_back(ring());
    rest_.remove_prefix(rest_.find(')') + 1);
    return polygon;
  }

  Ring ring() {
    Ring ring;
    rest_.remove_prefix(rest_.find('(') + 1);
    while (true) {
      const std::size_t end = rest_.find_first_of(",)");
      const std::string_view pair = rest_.substr(0, end);
      const std::size_t blank = pair.find_last_of(' ');
      const std::size_t first = pair.find_first_not_of(' ');
      ring.push_back({parse_number(pair.substr(first, blank - first)).value,
                      parse_number(pair.substr(blank + 1)).value});
      const bool last = rest_[end] == ')';
      rest_.remove_prefix(end + 1);
      if (last) return ring;
    }
  }

  std::string_view rest_;
};

}  // namespace thiessen
