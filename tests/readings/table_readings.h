#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/temporary_folder.h"
#include "readings/readings_reader.h"
#include "text/csv_reader.h"

namespace thiessen::table_readings {

using Texts = std::vector<std::string>;
/// Stands for NaN, which equals nothing, in what is compared.
constexpr double silent = -1;

inline std::vector<Station> stations_called(const Texts& ids) {
  std::vector<Station> stations;
  for (const std::string& id : ids) stations.push_back({id, {}, stations.size() + 2});
  return stations;
}

/// What a reader makes of a table, without the folder in what it says.
struct Outcome {
  Texts times;
  std::vector<std::vector<double>> readings;
  Texts sentences;
  Texts hints;
  Texts warnings;
  std::size_t unlisted = 0;
};

/// Reads tables of text, wide or long, with these stations and options.
class Reader {
 public:
  Reader(Texts ids = {"A", "B", "C"}) : stations_(stations_called(ids)) {}

  ReadingsOptions options;
  Texts passed_over;

  Outcome read(const std::string& text) {
    const TemporaryFolder folder;
    const std::string path = folder.write("r.csv", text);
    Outcome outcome;
    Warnings warnings;
    try {
      read_steps(path, warnings, outcome);
    } catch (const Error& error) {
      for (const Message& message : error.messages()) {
        outcome.sentences.push_back(message.sentence().substr(path.size() - 5));
        outcome.hints.push_back(message.hint.plain());
      }
      outcome.unlisted = error.unlisted();
    }
    for (const Message& message : warnings.messages()) {
      outcome.warnings.push_back(message.sentence().substr(path.size() - 5));
    }
    return outcome;
  }

 private:
  void read_steps(const std::string& path, Warnings& warnings, Outcome& outcome) {
    const auto readings =
        open_readings(std::make_unique<CsvReader>(path), stations_, passed_over, options, warnings);
    TimeStep step;
    while (readings->next(step)) {
      outcome.times.push_back(step.time);
      outcome.readings.emplace_back(step.readings.begin(), step.readings.end());
      for (double& reading : outcome.readings.back()) {
        if (std::isnan(reading)) reading = silent;
      }
    }
    EXPECT_FALSE(readings->next(step)) << "the end stays the end";
  }

  std::vector<Station> stations_;
};

inline void expect_readings(const Outcome& outcome, const Texts& times,
                            const std::vector<std::vector<double>>& readings) {
  EXPECT_EQ(outcome.sentences, Texts{});
  EXPECT_EQ(outcome.times, times);
  EXPECT_EQ(outcome.readings, readings);
}

}  // namespace thiessen::table_readings
