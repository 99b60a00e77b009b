// Thiessen weights and rainfall of problem 3.4.5 of Chow, Maidment and Mays, Applied Hydrology
// (1988), with the library alone and all data in memory: gauges 2, 3, 5, 7, 8 and 9 weigh,
// and 69.8364 mm fell.
#include <iostream>
#include <vector>

#include <thiessen.h>

int main() {
  thiessen::ThiessenInput input;
  input.stations = {{"1", {7, 4}},   {"2", {3, 4}},   {"3", {-2, 5}},
                    {"4", {-10, 1}}, {"5", {-3, -3}}, {"6", {-7, -7}},
                    {"7", {2, -3}},  {"8", {2, -10}}, {"9", {0, 0}}};
  input.basins = {{"A", {{{{5, 5}, {-5, 5}, {-5, -5}, {0, -10}, {5, -5}}, {}}}, {}}};
  const std::vector<double> storm = {62, 59, 41, 39, 105, 98, 60, 41, 81};  // millimetres
  try {
    const thiessen::Thiessen study(input);
    for (const thiessen::Message& warning : study.warnings())
      std::cerr << "warning: " << warning.sentence() << '\n';
    for (const thiessen::StationWeight& gauge : study.weights()[0].stations)
      std::cout << study.stations()[thiessen::index(gauge.station)].id << ": " << gauge.weight
                << '\n';
    std::cout << "rainfall: " << study.rainfall(storm)[0].rainfall << " mm\n";
  } catch (const thiessen::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
