#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "benchmarks/timer.h"
#include "io/readings_reader.h"
#include "io/table_file.h"

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

void read_table(benchmark::State& state, void (*write)(std::ofstream&, Size)) {
  const Size size = {static_cast<std::size_t>(state.range(1)),
                     static_cast<std::size_t>(state.range(0)) * 1'000'000 /
                         static_cast<std::size_t>(state.range(1))};
  const TemporaryFolder folder;
  const std::string path = folder.path("rainfall.csv");
  {
    std::ofstream file(path, std::ios::binary);
    write(file, size);
  }
  const std::vector<Station> gauges = stations(size.stations);
  for ([[maybe_unused]] auto _ : state) {
    Timer timer;
    timer.start();
    Warnings warnings;
    const auto readings = open_readings(open_table(path, '\0'), gauges, {}, {}, warnings);
    double sum = 0;
    std::size_t steps = 0;
    for (TimeStep step; readings->next(step); ++steps) sum += step.readings[steps % gauges.size()];
    timer.stop();
    benchmark::DoNotOptimize(sum);
    if (steps != size.steps) state.SkipWithError("not all steps are read");
    count_operations(state, size.stations * size.steps, timer);
  }
  rusage use = {};
  getrusage(RUSAGE_SELF, &use);
  state.counters["peak MB so far"] = static_cast<double>(use.ru_maxrss) / 1024;
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

/// Million readings; stations.
#define THIESSEN_READINGS(name) \
  BENCHMARK(name)->Name("readings/" #name)->UseManualTime()->Unit(benchmark::kMillisecond)
THIESSEN_READINGS(wide)->Args({20, 1000})->Args({100, 1000});
THIESSEN_READINGS(long_by_time)->Args({20, 1000})->Args({20, 1});
THIESSEN_READINGS(long_by_station)->Args({20, 1000})->Args({20, 10});
THIESSEN_READINGS(long_scattered)->Args({20, 1000});

}  // namespace
}  // namespace thiessen::benchmarks
