// What fuzzers found in readings/, numbered on from room to room.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "readings/readings_grammar.h"

namespace thiessen {
namespace {

TEST(ReadingGrammar, finding_4_takes_a_gap_as_written_beside_decimal_commas) {
  const std::vector<std::string> missing = {"0.51"};
  const ReadingGrammar grammar(missing, {}, DecimalMark::comma);
  for (const char* gap : {"0.51", "0,51", "-99.9", "-99,9"})
    EXPECT_EQ(grammar.read(gap, false).kind, ReadingKind::missing) << gap;
  EXPECT_EQ(grammar.read("0.52", false).kind, ReadingKind::not_a_number);
}

}  // namespace
}  // namespace thiessen
