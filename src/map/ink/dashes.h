#pragma once

#include <vector>

namespace thiessen {

/// A dash along a line, from one length to another.
struct Dash {
  double from = 0;
  double to = 0;
};

/// The dashes of a line: as near to the given lengths of dash and gap as a dash at either end
/// allows, two at least. A line shorter than a gap is one dash.
std::vector<Dash> dashes(double length, double dash, double gap);

}  // namespace thiessen
