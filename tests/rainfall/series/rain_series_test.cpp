// Steps computed block by block on several threads, and handed on in their order.
#include "rainfall/series/rain_series.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "rainfall/gaps/gappy_study.h"
#include "rainfall/series/readings_of.h"

namespace thiessen {
namespace {

void ignore(RainStep&) {}

class Table : public Readings {
 public:
  explicit Table(const std::vector<std::vector<double>>& steps) : steps_(steps) {}
  bool next(TimeStep& step) override {
    if (next_ == steps_.size()) return false;
    step = {std::to_string(next_), steps_[next_]};
    ++next_;
    return true;
  }

 private:
  const std::vector<std::vector<double>>& steps_;
  std::size_t next_ = 0;
};

void expect_same(const std::vector<BasinRainfall>& a, const std::vector<BasinRainfall>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::isnan(a[i].rainfall), std::isnan(b[i].rainfall));
    ASSERT_TRUE(std::isnan(a[i].rainfall) || a[i].rainfall == b[i].rainfall);
    ASSERT_EQ(a[i].gauges, b[i].gauges);
    ASSERT_EQ(a[i].coverage, b[i].coverage);
  }
}

TEST(RainSeries, comes_in_order_and_does_not_depend_on_the_number_of_threads) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  std::vector<std::vector<double>> patterns;
  for (int i = 0; i < 7; ++i) patterns.push_back(gappy::readings_of(seeded, study, 0.2));
  std::vector<std::vector<double>> steps;
  for (int i = 0; i < 700; ++i) {
    steps.push_back(patterns[seeded.below(7)]);
    for (double& reading : steps.back()) reading *= seeded.uniform(0, 1);
  }
  const ArealRainfall once(study.weighing, {}, 1);
  for (const SeriesWork& work : {SeriesWork{1, 256}, SeriesWork{2, 1}, SeriesWork{7, 100}}) {
    const std::size_t cache = 100000 * work.threads - 100000;
    const ArealRainfall rainfall(study.weighing, {Gaps::retessellate, 1, true, cache}, 1);
    Table table(steps);
    std::size_t next = 0;
    const std::size_t count =
        for_each_step(table, rainfall, work, ignore, [&](const RainStep& step) {
          ASSERT_EQ(step.time, std::to_string(next));
          expect_same(step.basins, once.at(steps[next]));
          ++next;
        });
    EXPECT_EQ(count, 700u);
    EXPECT_EQ(next, 700u);
  }
}

/// One basin, whose rainfall is the first gauge's reading; it may throw at a reading.
class FirstGauge : public StepRainfall {
 public:
  explicit FirstGauge(double bad = -1) : bad_(bad) {}
  std::vector<BasinRainfall> at(std::span<const double> readings) const override {
    if (readings.front() == bad_) throw std::domain_error("bad");
    return {{readings.front(), 1, 1}};
  }
  std::vector<BasinWeights> weights_at(std::span<const double>) const override { return {}; }

 private:
  double bad_;
};

// ReadingsOf: step i reads i, and stands in line i + 2.
TEST(RainSeries, hands_on_each_step_whole_with_what_was_prepared) {
  const FirstGauge rainfall;
  for (const unsigned threads : {1u, 3u}) {
    ReadingsOf table(std::vector<std::string>(50, "2013-08"));
    std::size_t next = 0;
    const auto prepare = [](RainStep& step) {
      EXPECT_TRUE(step.text.empty());  // memory is used again, but not its text
      step.text = std::to_string(step.line) + ":" + std::to_string(step.basins.size());
    };
    for_each_step(table, rainfall, {threads, 8}, prepare, [&](const RainStep& step) {
      EXPECT_EQ(step.time, "2013-08");
      EXPECT_EQ(step.readings, std::vector<double>{static_cast<double>(next)});
      EXPECT_EQ(step.basins[0].rainfall, static_cast<double>(next));
      EXPECT_EQ(step.line, next + 2);
      EXPECT_EQ(step.text, std::to_string(next + 2) + ":1");
      ++next;
    });
    EXPECT_EQ(next, 50u);
  }
}

TEST(RainSeries, hands_on_what_is_thrown_by_whom_it_may) {
  const auto nothing = [](const RainStep&) {};
  for (const unsigned threads : {1u, 2u}) {
    const SeriesWork work{threads, 3};
    const std::vector<std::string> times(10, "2013");
    ReadingsOf taken(times);
    EXPECT_THROW(for_each_step(taken, FirstGauge(), work, ignore, [](const RainStep&) { throw 7; }),
                 int);
    ReadingsOf computed(times);
    EXPECT_THROW(for_each_step(computed, FirstGauge(5), work, ignore, nothing), std::domain_error);
    ReadingsOf prepared(times);
    EXPECT_THROW(for_each_step(
                     prepared, FirstGauge(), work, [](RainStep&) { throw 'c'; }, nothing),
                 char);
    ReadingsOf read(times, Message{"rain.csv", 3, "a bad row", ""});
    EXPECT_THROW(for_each_step(read, FirstGauge(), work, ignore, nothing), Error);
  }
}

TEST(RainSeries, of_no_steps_hands_on_none) {
  ReadingsOf empty({});
  EXPECT_EQ(
      for_each_step(empty, FirstGauge(), {2, 3}, ignore, [](const RainStep&) { ADD_FAILURE(); }),
      0u);
}

/// Readings that come in bursts: `next` would wait between them.
class Bursts : public ReadingsOf {
 public:
  Bursts(std::vector<std::size_t> sizes, std::optional<Message> fault = std::nullopt)
      : ReadingsOf(std::vector<std::string>(sum(sizes), "2013"), std::move(fault)),
        sizes_(std::move(sizes)) {}

  bool next(TimeStep& step) override {
    EXPECT_FALSE(at_ + 1 < sizes_.size() && given_ == sizes_[at_]) << "this would wait";
    ++given_;
    return ReadingsOf::next(step);
  }
  bool is_waiting(std::chrono::milliseconds patience) override {
    if (at_ + 1 >= sizes_.size() || given_ < sizes_[at_]) return false;
    if (patience.count() == 0) return true;
    ++at_;
    given_ = 0;
    return false;
  }

 private:
  static std::size_t sum(const std::vector<std::size_t>& sizes) {
    std::size_t all = 0;
    for (const std::size_t size : sizes) all += size;
    return all;
  }

  std::vector<std::size_t> sizes_;
  std::size_t at_ = 0;
  std::size_t given_ = 0;
};

// What has come is handed on before anything else is waited for, by any number of threads.
TEST(RainSeries, of_a_pipe_is_handed_on_as_it_comes) {
  for (const unsigned threads : {1U, 3U}) {
    Bursts bursts({1, 5, 1, 40});
    std::vector<std::size_t> handed_on;
    std::size_t taken = 0;
    SeriesWork work{threads};
    work.when_handed_on = [&] {
      if (handed_on.empty() || handed_on.back() != taken) handed_on.push_back(taken);
    };
    EXPECT_EQ(for_each_step(bursts, FirstGauge(), work, ignore, [&](const RainStep&) { ++taken; }),
              47U);
    ASSERT_GE(handed_on.size(), 3U);
    EXPECT_EQ(std::vector(handed_on.begin(), handed_on.begin() + 3),
              (std::vector<std::size_t>{1, 6, 7}));
  }
}

TEST(RainSeries, of_a_pipe_has_all_steps_before_a_fault) {
  for (const unsigned threads : {1U, 3U}) {
    Bursts bursts({2, 5}, Message{"rain.csv", 9, "a bad row", ""});
    std::size_t taken = 0;
    std::size_t handed_on = 0;
    SeriesWork work{threads};
    work.when_handed_on = [&] { handed_on = taken; };
    EXPECT_THROW(
        for_each_step(bursts, FirstGauge(), work, ignore, [&](const RainStep&) { ++taken; }),
        Error);
    EXPECT_EQ(handed_on, 7U);
  }
}

}  // namespace
}  // namespace thiessen
