#include "readings/readings_dly.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "readings/dly/dly_files.h"
#include "readings/dly_text.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;
using Days = std::map<int, DlyColumns>;
constexpr double silent = -1;  // stands for NaN, which equals nothing, in what is compared

const std::string a = "USC00050001";
const std::string b = "USC00050002";

using Row = std::vector<double>;

struct Series {
  Texts times;
  std::vector<std::vector<double>> readings;
  Texts warnings;

  std::vector<double> on(const std::string& day) const {
    const auto found = std::find(times.begin(), times.end(), day);
    return found == times.end() ? std::vector<double>{}
                                : readings[static_cast<std::size_t>(found - times.begin())];
  }
};

class DlyTest : public ::testing::Test {
 protected:
  TemporaryFolder folder;
  ReadingsOptions options;
  Texts ids = {a, b};
  Texts passed_over;

  void write(const std::string& name, const Texts& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    folder.write(name, text);
  }

  Series read(const std::string& name = "") {
    std::vector<Station> stations;
    for (const std::string& id : ids) stations.push_back({id, {}, stations.size() + 2});
    Warnings warnings;
    const std::string path = name.empty() ? folder.path() : folder.path(name);
    const auto readings = open_dly_readings(path, stations, passed_over, options, warnings);
    Series series;
    TimeStep step;
    double share = 0;
    while (readings->next(step)) {
      EXPECT_GE(readings->share_read(), share);
      EXPECT_LE(readings->share_read(), 1);
      share = readings->share_read();
      series.times.push_back(step.time);
      series.readings.emplace_back(step.readings.begin(), step.readings.end());
      for (double& reading : series.readings.back()) {
        if (std::isnan(reading)) reading = silent;
      }
    }
    EXPECT_FALSE(readings->next(step)) << "the end stays the end";
    for (std::string sentence : sentences_of(warnings)) series.warnings.push_back(shown(sentence));
    return series;
  }

  Texts complaints(const std::string& name = "") {
    Texts all = complaints_of([&] { read(name); });
    for (std::string& sentence : all) sentence = shown(sentence);
    return all;
  }

 private:
  /// Without the folder's own name.
  std::string shown(std::string sentence) const {
    for (std::size_t at; (at = sentence.find(folder.path() + "/")) != std::string::npos;) {
      sentence.erase(at, folder.path().size() + 1);
    }
    if (sentence.starts_with(folder.path())) sentence.replace(0, folder.path().size(), "FOLDER");
    return sentence;
  }
};

TEST_F(DlyTest, tenths_of_a_millimetre_become_millimetres_day_by_day) {
  write("a.dly",
        {dly_line(a, 2020, 2, {{28, {"12"}}, {29, {"0"}}}),
         dly_line(a, 2020, 2, {{28, {"250"}}}, "TMAX"), dly_line(a, 2020, 3, {{1, {"1003"}}})});
  write("b.dly", {dly_line(b, 2020, 2, {{29, {"7"}}})});
  const Series series = read();
  EXPECT_EQ(series.times.size(), 29u + 31);
  EXPECT_EQ(series.times.front(), "2020-02-01");
  EXPECT_EQ(series.times.back(), "2020-03-31");
  EXPECT_EQ(series.on("2020-02-27"), (Row{silent, silent}));
  EXPECT_EQ(series.on("2020-02-28"), (Row{1.2, silent}));
  EXPECT_EQ(series.on("2020-02-29"), (Row{0, 0.7}));
  EXPECT_EQ(series.on("2020-03-01"), (Row{100.3, silent}));
  EXPECT_EQ(series.on("2020-03-02"), (Row{silent, silent}));
  EXPECT_EQ(series.warnings, Texts{});
}

TEST_F(DlyTest, days_without_a_value_are_steps_of_silent_gauges) {
  ids = {a};
  write("a.dly", {dly_line(a, 1999, 12, {{31, {"5"}}}), dly_line(a, 2000, 3, {{1, {"6"}}})});
  const Series series = read("a.dly");
  ASSERT_EQ(series.times.size(), 31u + 31 + 29 + 31);
  EXPECT_EQ(series.times[31], "2000-01-01");
  EXPECT_EQ(series.times[90], "2000-02-29");
  for (std::size_t i = 0; i < series.times.size(); ++i) {
    const double expected = i == 30 ? 0.5 : i == 91 ? 0.6 : silent;
    EXPECT_EQ(series.readings[i][0], expected) << series.times[i];
  }
}

TEST_F(DlyTest, years_are_leap_years_by_gregorys_rule) {
  ids = {a};
  for (const auto& [year, days] : {std::pair{1900, 59u}, {2000, 60u}, {2019, 59u}, {2020, 60u}}) {
    write("a.dly", {dly_line(a, year, 2, {{28, {"1"}}}), dly_line(a, year, 3, {{1, {"1"}}})});
    EXPECT_EQ(read("a.dly").times.size(), days) << year;
  }
}

TEST_F(DlyTest, values_that_failed_a_check_are_missing_unless_they_are_kept) {
  write("a.dly", {dly_line(a, 2020, 1, {{1, {"10", " G7"}}, {2, {"20", "  7"}}, {3, {"0", "T 7"}}}),
                  dly_line(b, 2020, 1, {{1, {"-5", " K "}}, {2, {"3"}}})});
  const Series series = read();
  EXPECT_EQ(series.on("2020-01-01"), (Row{silent, silent}));
  EXPECT_EQ(series.on("2020-01-02"), (Row{2, 0.3}));
  EXPECT_EQ(series.on("2020-01-03"), (Row{0, silent}));
  options.keep_flagged = true;
  EXPECT_EQ(complaints(),
            Texts{"a.dly:2: value '-5' of station 'USC00050002' on 2020-01-01 is negative"});
  write("a.dly", {dly_line(a, 2020, 1, {{1, {"10", " G7"}}, {2, {"20", "  7"}}})});
  const Series kept = read();
  EXPECT_EQ(kept.on("2020-01-01"), (Row{1, silent}));
  EXPECT_EQ(kept.on("2020-01-02"), (Row{2, silent}));
}

TEST_F(DlyTest, one_file_may_hold_many_stations_in_any_order) {
  write("all.dly", {dly_line(b, 2020, 5, {{1, {"4"}}}), dly_line(b, 2020, 4, {{30, {"3"}}}),
                    dly_line(a, 2020, 4, {{30, {"1"}}}), dly_line(a, 2020, 5, {{1, {"2"}}})});
  const Series series = read("all.dly");
  EXPECT_EQ(series.times.size(), 30u + 31);
  EXPECT_EQ(series.on("2020-04-30"), (Row{0.1, 0.3}));
  EXPECT_EQ(series.on("2020-05-01"), (Row{0.2, 0.4}));
}

TEST_F(DlyTest, lines_may_end_in_crlf_and_lack_blanks_at_their_end) {
  ids = {a};
  std::string line = dly_line(a, 2020, 1, {{31, {"8"}}});
  folder.write("a.dly",
               line.substr(0, line.size() - 3) + "\r\n\n" + dly_line(a, 2020, 2, {{1, {"9"}}}));
  const Series series = read("a.dly");
  EXPECT_EQ(series.on("2020-01-31"), Row{0.8});
  EXPECT_EQ(series.on("2020-02-01"), Row{0.9});
}

TEST_F(DlyTest, bad_lines_are_all_told) {
  const std::string good = dly_line(a, 2020, 1, {{1, {"1"}}});
  write("a.dly", {good.substr(0, 200), dly_line(a, 2020, 13, {}), dly_line(a, 1492, 1, {}),
                  dly_line(a, 2020, 2, {{30, {"1"}}}), dly_line(a, 2020, 3, {{7, {"1x"}}}),
                  dly_line(a, 2020, 4, {{8, {""}}}), good + "more",
                  dly_line(a, 2020, 5, {{1, {"-1"}}}), "x"});
  write("b.dly", {dly_line(b, 2020, 1, {{2, {"- 1"}}})});
  EXPECT_EQ(complaints(),
            (Texts{"a.dly:1: the line is cut: it has 200 of 269 characters",
                   "a.dly:2: columns 16 and 17, '13', are no month from 01 to 12",
                   "a.dly:3: columns 12 to 15, '1492', are no year from 1700 to 2299",
                   "a.dly:4: 2020-02 has no day 30, but there is a value: '1'",
                   "a.dly:5: value '1x' of station 'USC00050001' on 2020-03-07 is no number",
                   "a.dly:6: value '' of station 'USC00050001' on 2020-04-08 is no number",
                   "a.dly:7: the line has more than 269 characters",
                   "a.dly:8: value '-1' of station 'USC00050001' on 2020-05-01 is negative",
                   "a.dly:9: the line is cut: it has 1 of 269 characters",
                   "b.dly:1: value '- 1' of station 'USC00050002' on 2020-01-02 is no number"}));
}

TEST_F(DlyTest, a_file_cut_anywhere_in_its_last_line_is_refused) {
  const std::string line = dly_line(a, 2020, 1, {{31, {"12", "  7"}}});
  for (std::size_t size = 1; size < line.size(); ++size) {
    folder.write("a.dly", line + "\n" + line.substr(0, size));
    const Texts found = complaints("a.dly");
    ASSERT_EQ(found[0],
              "a.dly:2: the line is cut: it has " + std::to_string(size) + " of 269 characters");
  }
}

TEST_F(DlyTest, a_month_given_twice_is_told_with_both_places) {
  write("a.dly", {dly_line(a, 2020, 1, {{1, {"1"}}}), dly_line(a, 2020, 2, {{1, {"1"}}}),
                  dly_line(a, 2020, 2, {{1, {"1"}}})});
  write("b.dly", {dly_line(b, 2020, 1, {{1, {"1"}}}), dly_line(a, 2020, 1, {{9, {"1"}}})});
  EXPECT_EQ(complaints(), (Texts{"a.dly:3: station 'USC00050001' has 2020-02 already in a.dly:2",
                                 "b.dly:2: station 'USC00050001' has 2020-01 already in a.dly:1"}));
}

TEST_F(DlyTest, unknown_stations_are_told_or_passed_over_with_their_days) {
  ids = {b};
  write("a.dly", {dly_line(a, 1950, 1, {{1, {"x"}}}), dly_line(a, 1950, 2, {{1, {"1"}}})});
  write("b.dly", {dly_line(b, 2020, 1, {{1, {"1"}}})});
  write("c.dly", {dly_line("USC00050003", 2020, 1, {}, "TMAX")});
  EXPECT_EQ(complaints(), Texts{"a.dly:1: unknown station 'USC00050001' | "
                                "'ignore_unknown' reads the stations of 'stations' alone"});
  options.ignore_unknown = true;
  const Series series = read();
  EXPECT_EQ(series.times.size(), 31u);
  EXPECT_EQ(series.times.front(), "2020-01-01");
  EXPECT_EQ(series.warnings, Texts{"FOLDER: an unknown station is passed over: 'USC00050001'"});
  options.ignore_unknown = false;
  passed_over = {a};
  EXPECT_EQ(read().times.size(), 31u);
  EXPECT_EQ(read().warnings, Texts{});
}

TEST_F(DlyTest, stations_without_readings_and_files_without_rain_are_warned_of) {
  write("a.dly", {dly_line(a, 2020, 1, {{1, {"1"}}})});
  EXPECT_EQ(read().warnings, Texts{"FOLDER: station 'USC00050002' has no readings"});
  write("a.dly", {dly_line(a, 2020, 1, {{1, {"1"}}}, "TMIN")});
  EXPECT_EQ(read().times, Texts{});
  EXPECT_EQ(read().warnings,
            Texts{"FOLDER: there is no value of PRCP of any station of 'stations'"});
}

TEST_F(DlyTest, folders_and_files_that_cannot_be_are_refused) {
  EXPECT_EQ(complaints()[0],
            "FOLDER: is a folder without a .dly file | "
            "readings are a table, or .dly files of GHCN-Daily");
  EXPECT_EQ(complaints("b.dly")[0], "b.dly: cannot open: No such file or directory");
  folder.write("a.dly", "");
  EXPECT_EQ(complaints()[0], "a.dly: is empty");
  folder.write("a.dly", std::string(100'000, '1'));
  EXPECT_EQ(complaints()[0], "a.dly:1: the line is longer than 4096 bytes, the limit");
}

TEST_F(DlyTest, options_of_tables_are_refused) {
  write("a.dly", {dly_line(a, 2020, 1, {{1, {"1"}}})});
  options.missing = {"0"};
  EXPECT_EQ(complaints("a.dly")[0], "a.dly: 'missing' is for tables, not for .dly files");
}

TEST_F(DlyTest, are_known_by_their_name) {
  EXPECT_TRUE(is_dly("x/USC00050001.dly"));
  EXPECT_TRUE(is_dly("X.DLY"));
  EXPECT_TRUE(is_dly(folder.path()));
  EXPECT_FALSE(is_dly("-"));
  EXPECT_FALSE(is_dly("dly"));
}

TEST_F(DlyTest, are_the_same_whatever_the_memory_and_the_order_of_lines) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int round = 0; round < 30; ++round) {
    std::map<std::string, std::vector<double>> expected;
    std::vector<Texts> files(random() % 3 + 1);
    for (std::size_t s = 0; s < 2; ++s) {
      for (int month = 0; month < 40; ++month) {
        if (random() % 3 == 0) continue;
        const int year = 1999 + month / 12;
        Days days;
        for (int day = 1; day <= 28; ++day) {
          if (random() % 4 == 0) continue;
          const unsigned tenths = static_cast<unsigned>(random() % 2000);
          days[day] = {std::to_string(tenths)};
          char date[40];
          std::snprintf(date, sizeof date, "%04d-%02d-%02d", year, month % 12 + 1, day);
          auto& readings = expected.try_emplace(date, 2, silent).first->second;
          readings[s] = tenths / 10.0;
        }
        files[random() % files.size()].push_back(
            dly_line(s == 0 ? a : b, year, month % 12 + 1, days));
      }
    }
    const TemporaryFolder here;
    Texts names;
    for (Texts& lines : files) {
      if (round % 2 == 0) std::shuffle(lines.begin(), lines.end(), random);
      std::string text = "\n";
      for (const std::string& line : lines) text += line + "\n";
      if (!lines.empty()) names.push_back(here.write(std::to_string(names.size()), text));
    }
    const std::vector<Station> stations = {{a, {}, 2}, {b, {}, 3}};
    Warnings warnings;
    auto known = std::make_unique<const ReadingsStations>(stations, std::span<const std::string>());
    ReadingsFindings findings("f", *known, false, warnings);
    DlyReadings readings({"f", names, std::move(known), std::move(findings), false},
                         random() % 10'000);
    std::map<std::string, std::vector<double>> found;
    for (TimeStep step; readings.next(step);) {
      std::vector<double> values(step.readings.begin(), step.readings.end());
      for (double& value : values) value = std::isnan(value) ? silent : value;
      if (values != std::vector<double>{silent, silent}) found[step.time] = values;
    }
    ASSERT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace thiessen
