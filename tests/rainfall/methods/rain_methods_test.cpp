#include "rainfall/methods/rain_methods.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "rainfall/methods/method_study.h"

namespace thiessen {
namespace {

using namespace by_method;

const std::vector<RainMethod> all(all_methods.begin(), all_methods.end());

// Users write these names.
TEST(RainMethods, have_the_names_that_users_know) {
  EXPECT_EQ(names_of_methods(all),
            (std::vector<std::string>{"thiessen", "arithmetic", "idw", "natural"}));
  EXPECT_EQ(names_of_methods({RainMethod::natural, RainMethod::thiessen}),
            (std::vector<std::string>{"natural", "thiessen"}));
  EXPECT_TRUE(names_of_methods({RainMethod::idw}).empty());  // its values need no name
}

TEST(RainMethods, are_means_over_points_or_not) {
  EXPECT_FALSE(averages_points(RainMethod::thiessen));
  EXPECT_FALSE(averages_points(RainMethod::arithmetic));
  EXPECT_TRUE(averages_points(RainMethod::idw));
  EXPECT_TRUE(averages_points(RainMethod::natural));
}

std::vector<double> values_by(const std::vector<RainMethod>& methods, const Study& study) {
  Warnings warnings;
  const auto rainfall = rainfall_by(methods, study.weighing, {300, 0}, {}, 1, warnings);
  std::vector<double> values;
  for (const BasinRainfall& basin : rainfall->at(textbook::readings()))
    values.push_back(basin.rainfall);
  return values;
}

// By Thiessen's cells and the mean of gauges the textbook's own; idw as it is tested by itself.
TEST(RainMethods, one_gives_its_own_value_and_several_those_of_each_in_turn) {
  const Study study = textbook_study();
  std::vector<double> expected;
  for (const RainMethod method : all) {
    const auto value = values_by({method}, study);
    ASSERT_EQ(value.size(), 1u);
    expected.push_back(value[0]);
  }
  EXPECT_NEAR(expected[0], 119463938.0 / 1710625, 1e-12);
  EXPECT_NEAR(expected[1], (59 + 41 + 105 + 60 + 81) / 5.0, 1e-12);
  EXPECT_EQ(values_by(all, study), expected);
  EXPECT_EQ(values_by({RainMethod::natural, RainMethod::arithmetic}, study),
            (std::vector<double>{expected[3], expected[1]}));
}

std::vector<std::string> warnings_of(const std::vector<RainMethod>& methods,
                                     const std::vector<Basin>& basins) {
  const Study study({{"a", {0, -5}}, {"b", {0, 9}}, {"c", {-5, 2}}, {"d", {2, -5}}, {"e", {2, 9}}},
                    basins, plane);
  Warnings warnings;
  rainfall_by(methods, study.weighing, {400, 0}, {}, 1, warnings);
  std::vector<std::string> sentences;
  for (const Message& message : warnings.messages()) sentences.push_back(message.sentence());
  return sentences;
}

Basin square(std::string id, Point low, Point high) {
  return {std::move(id), {{shapes::rectangle(low, high), {}}}, {}};
}

// The hull ends at x = 2.
TEST(RainMethods, natural_neighbours_warn_of_basins_beyond_the_hull_and_name_the_worst) {
  const Basin within = square("within", {0, 0}, {2, 2});
  const Basin half = square("half", {0, 0}, {4, 4});
  const Basin beyond = square("beyond", {3, 0}, {4, 1});
  EXPECT_TRUE(warnings_of({RainMethod::natural}, {within}).empty());
  EXPECT_TRUE(warnings_of({RainMethod::idw, RainMethod::thiessen}, {half}).empty());
  EXPECT_EQ(warnings_of({RainMethod::natural}, {within, half}),
            std::vector<std::string>{"natural neighbours: 50.0 % of basin 'half' lies beyond the "
                                     "hull of the gauges, where the nearest gauge counts"});
  EXPECT_EQ(warnings_of(all, {half, beyond}),
            std::vector<std::string>{
                "natural neighbours: parts of 2 basins lie beyond the hull of the gauges, where "
                "the nearest gauge counts; of basin 'beyond' most, 100.0 %"});
}

}  // namespace
}  // namespace thiessen
