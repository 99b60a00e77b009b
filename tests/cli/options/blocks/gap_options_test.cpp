#include "cli/options/blocks/gap_options.h"

#include "cli/options/given_options.h"
#include "cli/options/named_enumerators.h"
#include "rainfall/gaps/gap_policies.h"

namespace thiessen::cli {
namespace {

struct GapsGiven : Given<GapOptions> {
  GapsGiven() { block.declare(options); }
};

TEST(GapOptions, retessellate_and_remember_256_megabytes_unless_told) {
  GapsGiven given;
  given.read({});
  EXPECT_EQ(given.block.settings().gaps, Gaps::retessellate);
  EXPECT_EQ(given.block.settings().min_gauges, 1U);
  EXPECT_EQ(given.block.settings().remembered_bytes, 268'435'456U);
}

TEST(GapOptions, know_every_policy_by_the_name_that_it_gives_itself) {
  for (const Gaps gaps : all_gaps) {
    GapsGiven given;
    given.read({"--gaps", name_of(gaps)});
    EXPECT_EQ(given.block.settings().gaps, gaps);
  }
  EXPECT_EQ(GapsGiven().refusal({"--gaps", "none"}),
            "--gaps wants retessellate, renormalise or strict, not 'none'");
}

// A policy that all_gaps lacks would compile, and nobody could ask for it.
TEST(GapOptions, offer_every_policy_that_there_is) {
  const GapsGiven given;
  EXPECT_EQ(given.options.at("--gaps").value.choices, names_of_enumerators<Gaps>(name_of));
}

TEST(GapOptions, count_gauges_from_1_and_memory_in_megabytes_from_0) {
  GapsGiven given;
  given.read({"--min-gauges", "4", "--cache", "0"});
  EXPECT_EQ(given.block.settings().min_gauges, 4U);
  EXPECT_EQ(given.block.settings().remembered_bytes, 0U);
  EXPECT_NE(GapsGiven().refusal({"--min-gauges", "0"}), "");
  EXPECT_NE(GapsGiven().refusal({"--cache", "1000001"}), "");
  GapsGiven largest;
  largest.read({"--cache", "1000000"});
  EXPECT_EQ(largest.block.settings().remembered_bytes, 1'048'576'000'000U);
}

TEST(GapOptions, may_be_the_memory_alone) {
  Given<GapOptions> given;
  given.block.declare_cache(given.options);
  given.read({"--cache", "1"});
  EXPECT_EQ(given.block.settings().remembered_bytes, 1'048'576U);
  EXPECT_EQ(given.refusal({"--gaps", "strict"}), "unknown option '--gaps'");
}

}  // namespace
}  // namespace thiessen::cli
