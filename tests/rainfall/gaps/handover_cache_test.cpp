// What is remembered of handovers: told by whether the same object comes again.
#include "rainfall/gaps/handover_cache.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/parallel.h"
#include "rainfall/gaps/nine_gauges.h"

namespace thiessen {
namespace {

class HandoverCacheOfNineGauges : public NineGauges {
 protected:
  /// All components of one cell, of two and of three.
  static std::vector<std::vector<PlaceIndex>> components() {
    std::vector<std::vector<PlaceIndex>> all;
    for (std::uint32_t i = 0; i < 9; ++i) {
      all.push_back(cells({i}));
      for (std::uint32_t k = i + 1; k < 9; ++k) {
        all.push_back(cells({i, k}));
        for (std::uint32_t l = k + 1; l < 9; ++l) all.push_back(cells({i, k, l}));
      }
    }
    return all;
  }
  void expect_right(const Handover& found, const std::vector<PlaceIndex>& component) const {
    const Handover expected = handovers_.of(component);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(found[i].basin, expected[i].basin);
      EXPECT_EQ(found[i].cell, expected[i].cell);
      EXPECT_EQ(found[i].weight, expected[i].weight);
    }
  }
};

TEST_F(HandoverCacheOfNineGauges, law_1_gives_the_same_whatever_it_keeps) {
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{20000}, std::size_t{1} << 20}) {
    HandoverCache cache(handovers_, bytes);
    for (int round = 0; round < 3; ++round) {
      for (const auto& component : components()) expect_right(*cache.of(component), component);
    }
  }
}

TEST_F(HandoverCacheOfNineGauges, law_2_with_room_it_makes_each_but_once) {
  HandoverCache cache(handovers_, std::size_t{1} << 20);
  std::vector<std::shared_ptr<const Handover>> first;
  for (const auto& component : components()) first.push_back(cache.of(component));
  std::size_t i = 0;
  for (const auto& component : components()) EXPECT_EQ(cache.of(component), first[i++]);
}

TEST_F(HandoverCacheOfNineGauges, law_3_without_room_it_keeps_none) {
  HandoverCache cache(handovers_, 0);
  for (const auto& component : components()) {
    const auto first = cache.of(component);
    EXPECT_NE(cache.of(component), first);
  }
}

// 40,000 bytes are two handovers for each generation of a sixteenth of the components.
TEST_F(HandoverCacheOfNineGauges, law_4_keeps_what_is_asked_for_again_and_forgets_the_rest) {
  HandoverCache cache(handovers_, 40000);
  const auto kept = cells({3, 4});
  const auto its_handover = cache.of(kept);
  std::vector<std::shared_ptr<const Handover>> first;
  std::vector<std::vector<PlaceIndex>> others;
  for (const auto& component : components()) {
    if (component.size() == 1 || component == kept) continue;
    others.push_back(component);
    first.push_back(cache.of(component));
    EXPECT_EQ(cache.of(kept), its_handover);
  }
  std::size_t forgotten = 0;
  for (std::size_t i = 0; i < others.size(); ++i) {
    expect_right(*first[i], others[i]);  // who holds one keeps it
    forgotten += cache.of(others[i]) == first[i] ? 0u : 1u;
  }
  EXPECT_GT(forgotten, others.size() / 4);
}

TEST_F(HandoverCacheOfNineGauges, law_5_is_safe_for_several_threads) {
  const auto all = components();
  for (const std::size_t bytes : {std::size_t{20000}, std::size_t{1} << 20}) {
    HandoverCache cache(handovers_, bytes);
    in_parallel(4 * all.size(), 4, [&](std::size_t, std::size_t i) {
      expect_right(*cache.of(all[i % all.size()]), all[i % all.size()]);
    });
  }
}

}  // namespace
}  // namespace thiessen
