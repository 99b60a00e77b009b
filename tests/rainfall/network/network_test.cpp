#include "rainfall/network/network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace thiessen {
namespace {

std::vector<Station> stations_at(const std::vector<Point>& positions) {
  std::vector<Station> stations;
  for (const Point p : positions)
    stations.push_back({std::to_string(stations.size()), p, stations.size() + 2});
  return stations;
}

std::vector<std::size_t> place_numbers(const std::vector<Point>& positions, Metric metric) {
  const Network network(stations_at(positions), metric);
  std::vector<std::size_t> numbers;
  for (std::uint32_t i = 0; i < positions.size(); ++i)
    numbers.push_back(index(network.place_of(StationIndex{i})));
  return numbers;
}

using Numbers = std::vector<std::size_t>;

TEST(Network, numbers_places_in_the_order_of_their_first_stations) {
  const std::vector<Point> positions{{3, 1}, {0, 0}, {3, 1}, {9, 9}, {0, 0}, {3, 1}};
  EXPECT_EQ(place_numbers(positions, Metric::planar), (Numbers{0, 1, 0, 2, 1, 0}));
  const Network network(stations_at(positions), Metric::planar);
  EXPECT_EQ(network.places(), (std::vector<Point>{{3, 1}, {0, 0}, {9, 9}}));
  const auto shared = network.stations_at(PlaceIndex{0});
  EXPECT_EQ(std::vector<StationIndex>(shared.begin(), shared.end()),
            (std::vector<StationIndex>{StationIndex{0}, StationIndex{2}, StationIndex{5}}));
  EXPECT_EQ(network.stations_at(PlaceIndex{2}).size(), 1u);
}

TEST(Network, takes_minus_zero_for_zero) {
  EXPECT_EQ(place_numbers({{0.0, -0.0}, {-0.0, 0.0}, {0, 0}}, Metric::planar), (Numbers{0, 0, 0}));
}

TEST(Network, joins_the_two_sides_of_the_antimeridian_on_the_earth_alone) {
  EXPECT_EQ(place_numbers({{180, 5}, {-180, 5}, {180, 6}}, Metric::geodesic), (Numbers{0, 0, 1}));
  EXPECT_EQ(place_numbers({{180, 5}, {-180, 5}}, Metric::planar), (Numbers{0, 1}));
}

TEST(Network, joins_all_longitudes_at_a_pole_on_the_earth_alone) {
  EXPECT_EQ(place_numbers({{10, 90}, {-77, 90}, {10, -90}}, Metric::geodesic), (Numbers{0, 0, 1}));
  EXPECT_EQ(place_numbers({{10, 90}, {-77, 90}}, Metric::planar), (Numbers{0, 1}));
}

TEST(Network, keeps_places_an_ulp_apart) {
  EXPECT_EQ(place_numbers({{1, 1}, {std::nextafter(1.0, 2.0), 1}}, Metric::planar),
            (Numbers{0, 1}));
}

TEST(Network, joins_what_is_within_a_micrometre_on_the_earth_alone) {
  const std::vector<Point> near{{10.5, 47.9}, {10.100000000001, 47.1}, {10.1, 47.1}};
  EXPECT_EQ(place_numbers(near, Metric::geodesic), (Numbers{0, 1, 1}));
  EXPECT_EQ(Network(stations_at(near), Metric::geodesic).places()[1], (Point{10.1, 47.1}));
  EXPECT_EQ(place_numbers(near, Metric::planar), (Numbers{0, 1, 2}));
}

TEST(Network, of_no_stations_has_no_places) {
  EXPECT_TRUE(Network({}, Metric::planar).places().empty());
}

}  // namespace
}  // namespace thiessen
