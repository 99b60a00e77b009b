#include "results/influence_file.h"

#include <cmath>
#include <string>

#include "base/number.h"
#include "text/csv_writer.h"

namespace thiessen {

void write_influence(OutputFile& file, const Weighing& weighing,
                     const std::vector<std::vector<GaugeInfluence>>& influence) {
  file.append("basin,station,weight,rms_change,mean_change\n");
  std::string row;
  for (std::size_t b = 0; b < influence.size(); ++b) {
    for (const GaugeInfluence& gauge : influence[b]) {
      row.clear();
      append_csv_field(row, weighing.basins()[b].id);
      row += ',';
      append_csv_field(row, weighing.network().stations()[index(gauge.station)].id);
      for (const double number : {gauge.weight, gauge.rms_change, gauge.mean_change}) {
        row += ',';
        if (!std::isnan(number)) append_shortest(row, number);
      }
      row += '\n';
      file.append(row);
    }
  }
}

}  // namespace thiessen
