#include "results/borders_file.h"

#include <cmath>
#include <string>

#include "base/interrupt.h"
#include "base/number.h"
#include "text/csv_writer.h"

namespace thiessen {

void write_borders(OutputFile& file, const Network& network, const NetworkDual& dual) {
  file.append("station,neighbour,length\n");
  std::string row;
  for (const StationBorder& border : dual.borders) {
    throw_if_interrupted();
    row.clear();
    append_csv_field(row, network.stations()[index(border.station)].id);
    row += ',';
    append_csv_field(row, network.stations()[index(border.neighbour)].id);
    row += ',';
    if (std::isfinite(border.length)) {
      append_shortest(row, border.length);
    } else {
      row += "inf";
    }
    row += '\n';
    file.append(row);
  }
}

}  // namespace thiessen
