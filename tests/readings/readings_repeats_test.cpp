#include "readings/readings_repeats.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/temporary_folder.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

using Found = std::set<std::tuple<std::string, std::size_t, std::size_t>>;

Found repeats_in(const std::vector<std::string>& times, bool readable_again, std::size_t memory) {
  const TemporaryFolder folder;
  std::string text = "time,A\n";
  for (const std::string& time : times) text += time + ",1\n";
  const std::string path = folder.write("r.csv", text);
  RepeatedTimes repeated(readable_again ? std::make_unique<CsvReader>(path) : nullptr, 0, memory);
  for (std::size_t i = 0; i < times.size(); ++i) repeated.note(times[i], i + 2);
  Found found;
  for (RepeatedTimes::Repeat repeat; repeated.next(repeat);) {
    found.emplace(repeat.time, repeat.line, repeat.first_line);
  }
  return found;
}

TEST(RepeatedTimes, are_those_given_before) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int round = 0; round < 100; ++round) {
    std::vector<std::string> times;
    const std::size_t different = random() % 300 + 1;
    for (std::size_t n = random() % 300; n > 0; --n) {
      times.push_back("t" + std::to_string(random() % different));
    }
    Found expected;
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const auto [at, fresh] = first.emplace(times[i], i + 2);
      if (!fresh) expected.emplace(times[i], i + 2, at->second);
    }
    ASSERT_EQ(repeats_in(times, round % 2 == 0, random() % 10'000), expected);
  }
}

TEST(RepeatedTimes, need_no_second_look_where_times_ascend) {
  EXPECT_EQ(repeats_in({"1", "2", "10"}, true, 100), Found{});
  EXPECT_EQ(repeats_in({"1", "2", "10"}, false, 1), Found{});
}

}  // namespace
}  // namespace thiessen
