#include "results/provenance.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(Provenance, has_only_what_is_known) {
  const Provenance some{"thiessen 0.1.0", "geodesic", "", 0.1, "thiessen", "", ""};
  EXPECT_EQ(sentence_of(some),
            "thiessen 0.1.0; metric: geodesic; tolerance: 0.1; method: thiessen");
  const Provenance all{"thiessen 0.1.0", "planar", "EPSG:32633", 2, "thiessen", "mm", "2000-01-01"};
  EXPECT_EQ(sentence_of(all),
            "thiessen 0.1.0; metric: planar; plane: EPSG:32633; tolerance: 2; method: thiessen; "
            "unit: mm; rainfall: 2000-01-01");
  EXPECT_EQ(items_of(all).at(0),
            (std::pair<std::string, std::string>{"software", "thiessen 0.1.0"}));
}

}  // namespace
}  // namespace thiessen
