#include "io/weights_file.h"

#include <string>

#include "base/number.h"
#include "io/csv_writer.h"

namespace thiessen {

void write_weights(OutputFile& file, const Weighing& weighing,
                   const std::vector<BasinWeights>& weights, AreaUnit unit) {
  file.append("basin,station,area_km2,weight\n");
  std::string row;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    for (const StationWeight& s : weights[b].stations) {
      row.clear();
      append_csv_field(row, weighing.basins()[b].id);
      row += ',';
      append_csv_field(row, weighing.network().stations()[index(s.station)].id);
      row += ',';
      append_shortest(row, s.area * unit.km2);
      row += ',';
      append_shortest(row, s.weight);
      row += '\n';
      file.append(row);
    }
  }
}

}  // namespace thiessen
