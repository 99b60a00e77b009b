#include "results/findings_file.h"

#include <cmath>

#include "base/number.h"
#include "text/csv_writer.h"

namespace thiessen {

FindingsFile::FindingsFile(OutputFile& file, const Network& network)
    : file_(file), network_(network) {
  file_.append("station,time,finding,value,expected\n");
}

void FindingsFile::add(const ReadingFinding& finding) {
  row_.clear();
  append_csv_field(row_, network_.stations()[index(finding.station)].id);
  row_ += ',';
  append_csv_field(row_, finding.time);
  row_ += std::string(",") + name_of(finding.kind) + ',';
  if (std::isfinite(finding.value)) {
    append_shortest(row_, finding.value);
  } else {
    row_ += "inf";
  }
  row_ += ',';
  if (!std::isnan(finding.expected)) append_shortest(row_, finding.expected);
  row_ += '\n';
  file_.append(row_);
}

}  // namespace thiessen
