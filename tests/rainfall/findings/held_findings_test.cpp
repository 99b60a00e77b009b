#include "rainfall/findings/held_findings.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(HeldFindings, come_back_in_their_order) {
  for (const std::size_t count : {0u, 3u, 100'000u}) {  // the last in a temporary file
    HeldFindings held;
    for (std::size_t i = 0; i < count; ++i) {
      held.add({StationIndex{static_cast<std::uint32_t>(i)}, FindingKind::zero,
                "time " + std::to_string(i), static_cast<double>(i), 0.5, 0, 2.5});
    }
    std::size_t passed = 0;
    held.pass_on([&](const ReadingFinding& finding) {
      ASSERT_EQ(finding.station, StationIndex{static_cast<std::uint32_t>(passed)});
      ASSERT_EQ(finding.kind, FindingKind::zero);
      ASSERT_EQ(finding.time, "time " + std::to_string(passed));
      ASSERT_EQ(finding.value, static_cast<double>(passed));
      ASSERT_EQ(finding.expected, 0.5);
      ASSERT_EQ(finding.excess, 2.5);
      ++passed;
    });
    EXPECT_EQ(passed, count);
  }
}

}  // namespace
}  // namespace thiessen
