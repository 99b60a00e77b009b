#include "results/cell_measures_file.h"

#include <cmath>
#include <cstddef>
#include <string>

#include "base/interrupt.h"
#include "base/number.h"
#include "tessellation/cell.h"
#include "tessellation/points_by_number.h"

namespace thiessen {
namespace {

double measure_of(const PlaneCell& cell) {
  return cell.area;
}
double measure_of(const SpaceCell& cell) {
  return cell.volume;
}
std::size_t sides_of(const PlaneCell& cell) {
  return cell.neighbours.size();
}
std::size_t sides_of(const SpaceCell& cell) {
  return cell.faces.size();
}

}  // namespace

template <int Dimension>
void write_cell_measures(OutputFile& file, const Tessellation<Dimension>& tessellation,
                         const NumberOf& number_of) {
  file.append(Dimension == 2 ? "point,area,sides\n" : "point,volume,sides\n");
  std::string row;
  for (const auto& [number, p] : points_by_number(tessellation, number_of)) {
    throw_if_interrupted();
    const auto cell = find_cell(tessellation, p);
    row = std::to_string(number) + ',';
    if (const double measure = measure_of(cell); std::isfinite(measure)) {
      append_shortest(row, measure);
    } else {
      row += "inf";
    }
    row += ',' + std::to_string(sides_of(cell)) + '\n';
    file.append(row);
  }
}

template void write_cell_measures(OutputFile&, const Tessellation<2>&, const NumberOf&);
template void write_cell_measures(OutputFile&, const Tessellation<3>&, const NumberOf&);

}  // namespace thiessen
