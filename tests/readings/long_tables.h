#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "readings/readings_layout.h"
#include "readings/readings_pieces.h"
#include "readings/readings_source.h"

namespace thiessen::long_tables {

/// Stands for NaN, which equals nothing, in what is compared.
constexpr double silent = -1;

struct TableRow {
  std::string time;
  std::size_t station;
  double amount;
};

struct Step {
  std::string time;
  std::vector<double> readings;

  bool operator==(const Step&) const = default;
};

/// The layout of what text_of writes.
inline const ReadingsLayout layout = {true, 0, 1, 2};

inline std::vector<Station> stations(std::size_t count) {
  std::vector<Station> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back({"S" + std::to_string(i), {}, i + 2});
  return all;
}

inline std::string text_of(const std::vector<TableRow>& rows) {
  std::string text = "time,station,rain\n";
  for (const TableRow& row : rows) {
    text += row.time + ",S" + std::to_string(row.station) + "," + std::to_string(row.amount) + "\n";
  }
  return text;
}

/// Rows of random times and stations, each pair once; `times` of them differ.
inline std::vector<TableRow> random_rows(std::mt19937& random, std::size_t times,
                                         std::size_t station_count) {
  std::vector<TableRow> rows;
  for (std::size_t t = 0; t < times; ++t) {
    for (std::size_t s = 0; s < station_count; ++s) {
      if (random() % 3 == 0) continue;
      rows.push_back({"t" + std::to_string(t), s, std::ldexp(random() % 100, -1)});
    }
  }
  return rows;
}

inline void by_station(std::vector<TableRow>& rows, std::mt19937&) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const TableRow& a, const TableRow& b) { return a.station < b.station; });
}

inline void shuffled(std::vector<TableRow>& rows, std::mt19937& random) {
  std::shuffle(rows.begin(), rows.end(), random);
}

/// The table once more, in memory: what readers of it are compared with.
inline std::vector<Step> steps_in_memory(const std::vector<TableRow>& rows,
                                         std::size_t station_count) {
  std::vector<Step> steps;
  std::map<std::string, std::size_t> number_of;
  for (const TableRow& row : rows) {
    const auto [at, fresh] = number_of.emplace(row.time, steps.size());
    if (fresh) steps.push_back({row.time, std::vector<double>(station_count, silent)});
    steps[at->second].readings[row.station] = row.amount;
  }
  return steps;
}

inline ReadingsSource source_of(std::unique_ptr<Table> table, const std::vector<Station>& gauges,
                                Warnings& warnings) {
  auto known = std::make_unique<const ReadingsStations>(gauges, std::span<const std::string>());
  ReadingsFindings findings(table->file(), *known, false, warnings);
  return {std::move(table), std::move(known), ReadingGrammar({}, {}, DecimalMark::point),
          std::move(findings)};
}

/// Steps from pieces; the same time must not come in two places.
inline std::vector<Step> steps_of(ReadingsPieces& pieces, std::size_t station_count) {
  std::vector<Step> steps;
  std::uint64_t first_line = 0;
  std::set<std::uint64_t> first_lines;
  for (ReadingsPiece piece; pieces.next(piece);) {
    if (steps.empty() || piece.first_line != first_line) {
      first_line = piece.first_line;
      EXPECT_TRUE(first_lines.insert(first_line).second);
      steps.push_back({std::string(piece.time), std::vector<double>(station_count, silent)});
    }
    EXPECT_EQ(piece.time, steps.back().time);
    for (const PieceReading& reading : piece.readings) {
      double& amount = steps.back().readings[index(reading.station)];
      EXPECT_EQ(amount, silent);
      amount = reading.amount;
      EXPECT_GE(piece.line + reading.lines_on, first_line);
    }
  }
  return steps;
}

}  // namespace thiessen::long_tables
