#include "rainfall/methods/weights_cache.h"

#include <gtest/gtest.h>

#include <atomic>

#include "base/parallel.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

/// One basin, all places alike; counts how often it is asked.
class Counting : public AreaMethod {
 public:
  using AreaMethod::weights;
  Weights weights(const ReportingPlaces& reports, const NormalMonth&) const override {
    ++asked;
    Weights weights(1);
    for (std::uint32_t i = 0; i < reports.size(); ++i) {
      if (reports[PlaceIndex{i}]) weights[0].push_back({PlaceIndex{i}, 1.0});
    }
    return weights;
  }
  mutable std::atomic<int> asked = 0;
};

ReportingPlaces random_set(Seeded& seeded, std::size_t places) {
  ReportingPlaces reports(places, false);
  for (std::uint32_t i = 0; i < places; ++i) reports.set(PlaceIndex{i}, seeded.below(2) == 0);
  return reports;
}

TEST(WeightsCache, asks_once_and_gives_what_the_method_gives) {
  Seeded seeded;
  const Counting method;
  WeightsCache cache(method, 1 << 20);
  const auto first = random_set(seeded, 100);
  const auto second = random_set(seeded, 100);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(*cache.of(first), Counting().weights(first));
    EXPECT_EQ(*cache.of(second), Counting().weights(second));
  }
  EXPECT_EQ(method.asked, 2);
}

TEST(WeightsCache, without_memory_it_asks_each_time) {
  Seeded seeded;
  const Counting method;
  WeightsCache cache(method, 0);
  const auto reports = random_set(seeded, 100);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(*cache.of(reports), Counting().weights(reports));
  EXPECT_EQ(method.asked, 5);
}

TEST(WeightsCache, forgets_what_was_not_asked_for_lately) {
  Seeded seeded;
  const Counting method;
  WeightsCache cache(method, 100'000);  // some tens of sets
  const auto kept = random_set(seeded, 100);
  std::vector<ReportingPlaces> others;
  for (int i = 0; i < 500; ++i) others.push_back(random_set(seeded, 100));
  for (const auto& reports : others) {
    EXPECT_EQ(*cache.of(reports), Counting().weights(reports));
    cache.of(kept);
  }
  EXPECT_EQ(method.asked, 501);
  cache.of(others.front());
  EXPECT_EQ(method.asked, 502);
}

TEST(WeightsCache, is_safe_for_several_threads) {
  Seeded seeded;
  const Counting method;
  WeightsCache cache(method, 30'000);
  std::vector<ReportingPlaces> sets;
  for (int i = 0; i < 40; ++i) sets.push_back(random_set(seeded, 100));
  in_parallel(2000, 4, [&](std::size_t, std::size_t i) {
    const auto& reports = sets[i % sets.size()];
    EXPECT_EQ(*cache.of(reports), Counting().weights(reports));
  });
}

}  // namespace
}  // namespace thiessen
