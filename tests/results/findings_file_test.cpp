#include "results/findings_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "results/written.h"

namespace thiessen {
namespace {

TEST(FindingsFile, has_a_row_a_finding_with_ids_as_written) {
  const TwoBasins study;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(written([&](OutputFile& file) {
              FindingsFile findings(file, study.network);
              findings.add({StationIndex{0}, FindingKind::spike, "2020-01-01", 100.1, 0.25});
              findings.add({StationIndex{1}, FindingKind::stuck, "2020-01-02", 0.2, unknown});
              findings.add({StationIndex{1}, FindingKind::unit, "", infinite, 1});
              findings.add({StationIndex{1}, FindingKind::jump, "", 1.5, 1, 1990});
            }),
            "station,time,finding,value,expected\n"
            "\"a\"\"b\",2020-01-01,spike,100.1,0.25\n"
            "007,2020-01-02,stuck,0.2,\n"
            "007,,unit,inf,1\n"
            "007,,break,1.5,1\n");
}

}  // namespace
}  // namespace thiessen
