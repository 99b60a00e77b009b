// Which steps a table has that an earlier run has written, and their values.
#include "results/earlier_rain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "base/complaints.h"

namespace thiessen {
namespace {

const RainShape wide = {"time,A,B\n", 1, {1, 2}};
const RainShape rows = {"time,basin,rainfall,gauges,coverage\n", 2, {2}};

EarlierRain earlier(const std::string& text, const RainShape& shape) {
  return {"r.csv", text.size(),
          [text](std::size_t at, std::span<char> into) {
            return text.substr(at).copy(into.data(), into.size());
          },
          shape};
}

std::vector<double> values(EarlierRain& rain, const std::string& time) {
  const std::vector<double>* found = rain.find(step_key(time));
  return found == nullptr ? std::vector<double>{-1} : *found;
}

TEST(EarlierRain, knows_its_steps_and_their_values) {
  for (const char* end : {"\n", "\r\n"}) {
    std::string text = "time,A,B\n2020-01-01,1.5,2\n2020-01-03,3,0.25\n";
    if (std::string(end) == "\r\n") text = "time,A,B\r\n2020-01-01,1.5,2\r\n2020-01-03,3,0.25\r\n";
    EarlierRain rain = earlier(text, wide);
    EXPECT_EQ(rain.steps(), 2U);
    EXPECT_EQ(rain.whole_bytes(), text.size());
    EXPECT_EQ(rain.has_crlf(), std::string(end) == "\r\n");
    EXPECT_EQ(values(rain, "2020-01-01"), (std::vector<double>{1.5, 2}));
    EXPECT_EQ(values(rain, "20200103"), (std::vector<double>{3, 0.25}));
    EXPECT_EQ(values(rain, "2020-01-02"), std::vector<double>{-1});
    EXPECT_EQ(values(rain, "2019-01-02"), std::vector<double>{-1});
    EXPECT_EQ(values(rain, "2021-01-02"), std::vector<double>{-1});
    EXPECT_FALSE(rain.cut());
  }
}

// More steps than lie between two places that are remembered, in three orders.
TEST(EarlierRain, finds_every_step_of_many_in_any_order) {
  constexpr int count = 3000;
  const auto time = [](int i) { return std::to_string(1000 + i); };
  for (const int stride : {1, count - 1, 7}) {
    for (const bool labels : {false, true}) {
      std::string text = "time,A,B\n";
      for (int i = 0; i < count; ++i) {
        const int step = i * stride % count;
        text += (labels ? "storm" : "") + time(step) + ',' + std::to_string(step) + ",0\n";
      }
      EarlierRain rain = earlier(text, wide);
      EXPECT_EQ(rain.steps(), 3000U);
      for (int i = 0; i < count; ++i) {
        const int step = i * 11 % count;
        ASSERT_EQ(values(rain, (labels ? "storm" : "") + time(step)),
                  (std::vector<double>{static_cast<double>(step), 0}))
            << step << ' ' << stride;
      }
      EXPECT_EQ(rain.find(step_key(time(count))), nullptr);
    }
  }
}

TEST(EarlierRain, takes_a_row_a_basin) {
  const std::string text =
      "time,basin,rainfall,gauges,coverage\n2020,A,1,1,1\n2020,B,2,1,1\n2021,A,,0,0\n2021,B,4,1,"
      "1\n";
  EarlierRain rain = earlier(text, rows);
  EXPECT_EQ(rain.steps(), 2U);
  EXPECT_EQ(values(rain, "2020"), (std::vector<double>{1, 2}));
  const std::vector<double> second = values(rain, "2021");
  EXPECT_TRUE(std::isnan(second.at(0)));
  EXPECT_EQ(second.at(1), 4);
}

TEST(EarlierRain, leaves_a_line_out_that_is_cut_off) {
  EarlierRain rain = earlier("time,A,B\n2020-01-01,1,2\n2020-01-02,3,4.1", wide);
  EXPECT_EQ(rain.steps(), 1U);
  EXPECT_EQ(rain.whole_bytes(), 24U);
  ASSERT_TRUE(rain.cut());
  EXPECT_TRUE(rain.cut()->may_be_whole);
  EXPECT_EQ(rain.cut()->key, step_key("2020-01-02"));
  EXPECT_EQ(rain.find(step_key("2020-01-02")), nullptr);
  const EarlierRain fewer = earlier("time,A,B\n2020-01-01,1,2\n2020-01-0", wide);
  EXPECT_FALSE(fewer.cut()->may_be_whole);
  EXPECT_FALSE(fewer.cut()->key);
}

TEST(EarlierRain, leaves_a_step_out_that_lacks_rows) {
  const std::string whole = "time,basin,rainfall,gauges,coverage\n2020,A,1,1,1\n2020,B,2,1,1\n";
  for (const char* rest : {"2021,A,3,1,1\n", "2021,A,3,1,1\n2021,B,4", "2021,A"}) {
    const EarlierRain rain = earlier(whole + rest, rows);
    EXPECT_EQ(rain.steps(), 1U);
    EXPECT_EQ(rain.whole_bytes(), whole.size());
    ASSERT_TRUE(rain.cut());
    EXPECT_EQ(rain.cut()->key, step_key("2021"));
    EXPECT_FALSE(rain.cut()->may_be_whole);
  }
  EXPECT_EQ(
      complaint_of([&] { earlier(whole + "2021,A,3,1,1\n2022,A,1,1,1\n2022,B,1,1,1\n", rows); }),
      "r.csv:4: the step '2021' has 1 of 2 rows | only a last step that was cut off is mended");
}

TEST(EarlierRain, names_the_first_column_that_differs) {
  const auto differs = [](const std::string& header) {
    return complaint_of([&] { earlier(header, wide); });
  };
  EXPECT_TRUE(contains(differs("time,A,C\n"), "column 3 is 'C', and this run writes 'B' there"));
  EXPECT_TRUE(contains(differs("time,A\n"), "has other columns: this run writes 3, also 'B'"));
  EXPECT_TRUE(contains(differs("time,A,B,C\n"), "has other columns: this run writes 3, not 'C'"));
  EXPECT_TRUE(contains(differs("time;A;B\n"), "column 1 is 'time;A;B'"));
  EXPECT_TRUE(contains(differs("time,A,B"), "its first line has no end"));
}

TEST(EarlierRain, refuses_rows_that_are_none) {
  EXPECT_TRUE(contains(complaint_of([] { earlier("time,A,B\n2020,1\n2021,1,2\n", wide); }),
                       "r.csv:2: row has 2 fields, the header has 3"));
}

TEST(EarlierRain, may_have_no_step) {
  EarlierRain rain = earlier("time,A,B\n", wide);
  EXPECT_EQ(rain.steps(), 0U);
  EXPECT_EQ(rain.find(step_key("2020")), nullptr);
}

}  // namespace
}  // namespace thiessen
