#include "results/models/raven_weights.h"

#include <string>

#include "base/number.h"

namespace thiessen {
namespace {

/// What Raven reads of a line: so many words, as released versions have it.
constexpr std::size_t most_words = 500;

}  // namespace

void RavenWeights::write(OutputFile& file, const WeightsSubject& subject,
                         Warnings& warnings) const {
  const std::vector<Station>& stations = subject.weighing.network().stations();
  const std::vector<Basin>& basins = subject.weighing.basins();
  file.append("# " + printable(sentence_of(subject.made_by)) + '\n');
  for (std::size_t s = 0; s < stations.size(); ++s)
    file.append("# gauge " + std::to_string(s + 1) + ": " + printable(stations[s].id) + '\n');
  for (std::size_t b = 0; b < basins.size(); ++b)
    file.append("# HRU " + std::to_string(b + 1) + ": " + printable(basins[b].id) + '\n');
  file.append(":GaugeWeightTable\n  " + std::to_string(stations.size()) + ' ' +
              std::to_string(basins.size()) + '\n');
  for (const BasinWeights& basin : subject.weights) {
    std::string row = " ";
    auto part = basin.stations.begin();
    for (std::size_t s = 0; s < stations.size(); ++s) {
      const bool weighs = part != basin.stations.end() && index(part->station) == s;
      row += ' ';
      if (weighs) {
        append_shortest(row, (part++)->weight);
      } else {
        row += '0';
      }
    }
    file.append(row + '\n');
  }
  file.append(":EndGaugeWeightTable\n");
  if (stations.size() <= most_words) return;
  warnings.add({file.name(), 0,
                "there are " + std::to_string(stations.size()) +
                    " gauges, and Raven's versions are known that read 500 numbers of a line",
                setting("stations_where") + " leaves out gauges that weigh in no basin"});
}

}  // namespace thiessen
