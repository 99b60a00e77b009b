#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "benchmarks/timer.h"
#include "files/tables/table_file.h"
#include "readings/readings_dly.h"
#include "readings/readings_reader.h"

namespace thiessen::benchmarks {
namespace {

/// Minute after minute; months have 28 days, for what matters is that they ascend.
std::string minute(std::size_t number) {
  const auto two = [](std::size_t n) {
    return std::string{char('0' + n / 10), char('0' + n % 10)};
  };
  const std::size_t days = number / 1440;
  return std::to_string(1900 + days / 336) + "-" + two(days / 28 % 12 + 1) + "-" +
         two(days % 28 + 1) + "T" + two(number / 60 % 24) + ":" + two(number % 60);
}

/// Three of four are 0, as rain is: "0", "7.5", "12".
std::string amount(std::mt19937& random) {
  const unsigned dice = static_cast<unsigned>(random());
  if (dice % 4 != 0) return "0";
  return dice % 8 == 0 ? std::to_string(dice / 8 % 60)
                       : std::to_string(dice / 8 % 60) + "." + std::to_string(dice / 512 % 10);
}

std::vector<Station> stations(std::size_t count) {
  std::vector<Station> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back({"S" + std::to_string(i), {}, i + 2});
  return all;
}

struct Size {
  std::size_t stations;
  std::size_t steps;
};

void write_wide(std::ofstream& file, Size size) {
  std::mt19937 random(1);
  file << "time";
  for (std::size_t s = 0; s < size.stations; ++s) file << ",S" << s;
  for (std::size_t t = 0; t < size.steps; ++t) {
    file << "\n" << minute(t);
    for (std::size_t s = 0; s < size.stations; ++s) file << ',' << amount(random);
  }
  file << "\n";
}

void write_row(std::ofstream& file, std::size_t step, std::size_t station, std::mt19937& random) {
  file << minute(step) << ",S" << station << ',' << amount(random) << "\n";
}

void write_by_time(std::ofstream& file, Size size) {
  std::mt19937 random(1);
  file << "time,station,rain\n";
  for (std::size_t t = 0; t < size.steps; ++t) {
    for (std::size_t s = 0; s < size.stations; ++s) write_row(file, t, s, random);
  }
}

void write_by_station(std::ofstream& file, Size size) {
  std::mt19937 random(1);
  file << "time,station,rain\n";
  for (std::size_t s = 0; s < size.stations; ++s) {
    for (std::size_t t = 0; t < size.steps; ++t) write_row(file, t, s, random);
  }
}

/// Every time and station once: the rows in steps that have no divisor with their number in common.
void write_scattered(std::ofstream& file, Size size) {
  std::mt19937 random(1);
  file << "time,station,rain\n";
  const std::size_t rows = size.steps * size.stations;
  const std::size_t stride = static_cast<std::size_t>(0.618 * static_cast<double>(rows)) | 1;
  for (std::size_t i = 0, at = 0; i < rows; ++i, at = (at + stride) % rows) {
    write_row(file, at / size.stations, at % size.stations, random);
  }
}

Size size_of(const benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(1));
  return {count, static_cast<std::size_t>(state.range(0)) * 1'000'000 / count};
}

/// Opens, reads all steps and counts the readings, which must be so many.
template <typename Open>
void read_all(benchmark::State& state, const std::vector<Station>& gauges, std::size_t expected,
              Open open) {
  Timer timer;
  timer.start();
  Warnings warnings;
  const std::unique_ptr<Readings> readings = open(warnings);
  std::size_t steps = 0;
  std::size_t last_gauge = 0;
  for (TimeStep step; readings->next(step); ++steps) {
    last_gauge += std::isnan(step.readings.back()) ? 0u : 1u;
  }
  timer.stop();
  if (steps == 0 || last_gauge * gauges.size() != expected) state.SkipWithError("wrong readings");
  count_operations(state, expected, timer);
  rusage use = {};
  getrusage(RUSAGE_SELF, &use);
  state.counters["peak MB so far"] = static_cast<double>(use.ru_maxrss) / 1024;
}

void read_table(benchmark::State& state, void (*write)(std::ofstream&, Size)) {
  const Size size = size_of(state);
  const TemporaryFolder folder;
  const std::string path = folder.path("rainfall.csv");
  {
    std::ofstream file(path, std::ios::binary);
    write(file, size);
  }
  const std::vector<Station> gauges = stations(size.stations);
  for ([[maybe_unused]] auto _ : state) {
    read_all(state, gauges, size.stations * size.steps, [&](Warnings& warnings) {
      return open_readings(open_table({path, {}, {}, {}}, warnings), gauges, {}, {}, warnings);
    });
  }
}

void wide(benchmark::State& state) {
  read_table(state, write_wide);
}
void long_by_time(benchmark::State& state) {
  read_table(state, write_by_time);
}
void long_by_station(benchmark::State& state) {
  read_table(state, write_by_station);
}
void long_scattered(benchmark::State& state) {
  read_table(state, write_scattered);
}

/// A file a station, of all months of so many years, with a second element as NOAA's have it.
void write_dly(const TemporaryFolder& folder, Size size) {
  std::mt19937 random(1);
  for (std::size_t s = 0; s < size.stations; ++s) {
    std::string name = "USC" + std::to_string(10'000'000 + s);
    std::ofstream file(folder.path(name + ".dly"), std::ios::binary);
    for (std::size_t month = 0; month < size.steps / 30; ++month) {
      for (const char* element : {"PRCP", "TMAX"}) {
        char head[64];
        std::snprintf(head, sizeof head, "%s%04zu%02zu%s", name.c_str(), 1800 + month / 12,
                      month % 12 + 1, element);
        file << head;
        for (std::size_t day = 1; day <= 31; ++day) {
          char columns[16];
          const bool is_there = day <= 28;
          std::snprintf(columns, sizeof columns, "%5d  7", is_there ? int(random() % 300) : -9999);
          file << columns;
        }
        file << '\n';
      }
    }
  }
}

void dly(benchmark::State& state) {
  const Size size = size_of(state);
  const TemporaryFolder folder;
  write_dly(folder, size);
  std::vector<Station> gauges;
  for (std::size_t s = 0; s < size.stations; ++s) {
    gauges.push_back({"USC" + std::to_string(10'000'000 + s), {}, s + 2});
  }
  for ([[maybe_unused]] auto _ : state) {
    read_all(state, gauges, size.stations * (size.steps / 30) * 28, [&](Warnings& warnings) {
      return open_dly_readings(folder.path(), gauges, {}, {}, warnings);
    });
  }
}

/// Million readings; stations.
#define THIESSEN_READINGS(name) \
  BENCHMARK(name)->Name("readings/" #name)->UseManualTime()->Unit(benchmark::kMillisecond)
THIESSEN_READINGS(wide)->Args({20, 1000})->Args({100, 1000});
THIESSEN_READINGS(long_by_time)->Args({20, 1000})->Args({20, 1})->Args({100, 1000});
THIESSEN_READINGS(long_by_station)->Args({20, 1000})->Args({20, 10})->Args({100, 1000});
THIESSEN_READINGS(long_scattered)->Args({20, 1000})->Args({100, 1000});
THIESSEN_READINGS(dly)->Args({20, 500})->Args({100, 1000});

}  // namespace
}  // namespace thiessen::benchmarks
