#include "rainfall/influence/search_budget.h"

#include <gtest/gtest.h>

#include <vector>

#include "rainfall/gaps/gappy_study.h"

namespace thiessen {
namespace {

StepSample random_sample(Seeded& seeded, const gappy::Study& study, int steps, double silent) {
  StepSample sample(study.network.stations().size(), 1000);
  for (int i = 0; i < steps; ++i) sample.add(gappy::readings_of(seeded, study, silent));
  return sample;
}

TEST(SearchBudget, law_1_steps_that_come_again_add_nothing_to_the_search) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Handovers handovers(study.weighing, 1);
  const StepSample once = random_sample(seeded, study, 10, 0.3);
  StepSample again(once.stations(), 1000);
  for (int i = 0; i < 30; ++i) again.add(once[static_cast<std::size_t>(i) % 10]);
  const SearchWork of_once = search_work(handovers, once, 10);
  const SearchWork of_again = search_work(handovers, again, 30);
  EXPECT_GT(of_once.all, 0);
  EXPECT_EQ(of_again.all, of_once.all);
  EXPECT_EQ(of_again.once, of_once.once);
}

TEST(SearchBudget, law_2_where_no_gauge_is_silent_all_steps_cost_nothing) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Handovers handovers(study.weighing, 1);
  const SearchWork work = search_work(handovers, random_sample(seeded, study, 10, 0), 10);
  EXPECT_EQ(work.all, 0);
  EXPECT_EQ(spacing_within(work, 1), 1u);
}

TEST(SearchBudget, law_3_the_share_bounds_what_is_looked_at) {
  const SearchWork work{1000, 20, 400, 100};
  EXPECT_EQ(spacing_within(work, 0.42), 1u);
  EXPECT_EQ(spacing_within(work, 0.41), 2u);
  EXPECT_EQ(spacing_within(work, 0.1), 5u);
  EXPECT_EQ(spacing_within(work, 0.03), 40u);
  EXPECT_EQ(spacing_within(work, 0.021), 100u) << "one step is looked at in any case";
  EXPECT_EQ(spacing_within(work, 0.001), 100u);
}

TEST(SearchBudget, law_5_the_least_is_there_for_every_run) {
  const SearchWork work{1000, 20, 400, 100};
  EXPECT_EQ(spacing_within(work, 0.001, 420), 1u);
  EXPECT_EQ(spacing_within(work, 0.001, 100), 5u);
  EXPECT_EQ(spacing_within(work, 0.42, 100), 1u) << "it takes nothing away from the share";
}

// Law: a longer series has more work, and so room to look at more of the same sample.
TEST(SearchBudget, law_4_longer_series_have_larger_budgets) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Handovers handovers(study.weighing, 1);
  const StepSample sample = random_sample(seeded, study, 60, 0.3);
  std::size_t before = 61;
  for (const std::size_t steps : {60u, 600u, 60'000u, 60'000'000u}) {
    const std::size_t spacing = spacing_within(search_work(handovers, sample, steps), 0.1);
    EXPECT_LE(spacing, before);
    before = spacing;
  }
  EXPECT_EQ(before, 1u);
}

}  // namespace
}  // namespace thiessen
