#include "results/borders_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "results/written.h"

namespace thiessen {
namespace {

TEST(BordersFile, has_a_row_a_pair_with_ids_as_written) {
  const TwoBasins study;
  NetworkDual dual;
  dual.borders = {{StationIndex{0}, StationIndex{1}, 0.1},
                  {StationIndex{0}, StationIndex{1}, std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(written([&](OutputFile& file) { write_borders(file, study.network, dual); }),
            "station,neighbour,length\n\"a\"\"b\",007,0.1\n\"a\"\"b\",007,inf\n");
}

}  // namespace
}  // namespace thiessen
