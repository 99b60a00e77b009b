#include "rainfall/errors/variogram_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

using Shape = VariogramModel::Shape;

std::vector<DistanceClass> classes_of(const VariogramModel& model) {
  std::vector<DistanceClass> classes;
  for (double distance = 1; distance < 200; distance *= 1.2)
    classes.push_back({distance, model(distance), distance * distance});
  return classes;
}

TEST(VariogramFit, finds_the_model_that_made_the_classes) {
  for (const double nugget : {0.0, 0.05, 0.3}) {
    for (const double range : {5.0, 20.0, 80.0, 400.0}) {
      for (const double exponent : {0.5, 1.0, 1.5, 1.9}) {
        const VariogramModel truth{Shape::stable, nugget, 0.8, range, exponent};
        const VariogramModel fit = fit_variogram(classes_of(truth));
        for (double distance = 1; distance < 200; distance *= 1.7)
          EXPECT_NEAR(fit(distance), truth(distance), 4e-3 * std::max(truth(distance), 1e-3))
              << range << exponent;
      }
      const VariogramModel truth{Shape::spherical, nugget, 0.8, range, 1};
      const VariogramModel fit = fit_variogram(classes_of(truth));
      EXPECT_EQ(fit.shape, Shape::spherical);
      for (double distance = 1; distance < 200; distance *= 1.7)
        EXPECT_NEAR(fit(distance), truth(distance), 4e-3 * std::max(truth(distance), 1e-3))
            << range;
    }
  }
}

TEST(VariogramFit, of_what_does_not_change_with_distance_is_the_nugget_alone) {
  const VariogramModel truth{Shape::stable, 0.7, 0, 1, 1};
  const VariogramModel fit = fit_variogram(classes_of(truth));
  for (double distance = 1; distance < 200; distance *= 2) EXPECT_NEAR(fit(distance), 0.7, 1e-9);
}

// What falls with distance is no variogram: the best valid one is flat.
TEST(VariogramFit, is_never_negative) {
  std::vector<DistanceClass> classes;
  for (double distance = 1; distance < 100; distance *= 1.3)
    classes.push_back({distance, 1 / distance, 1});
  const VariogramModel fit = fit_variogram(classes);
  EXPECT_GE(fit.nugget, 0);
  EXPECT_GE(fit.sill, 0);
  EXPECT_NEAR(fit(1), fit(100), 1e-6);
}

TEST(VariogramFit, takes_one_class_and_distances_of_any_size) {
  const std::vector<DistanceClass> one{{3, 0.4, 10}};
  EXPECT_NEAR(fit_variogram(one)(3), 0.4, 1e-6);
  for (const double unit : {1e-40, 1e-9, 1e9, 1e50}) {
    std::vector<DistanceClass> classes = classes_of({Shape::stable, 0.1, 0.9, 20, 1.2});
    for (DistanceClass& c : classes) c.distance *= unit;
    const VariogramModel fit = fit_variogram(classes);
    EXPECT_NEAR(fit(20 * unit), 0.1 + 0.9 * (1 - std::exp(-1)), 4e-3);
  }
}

TEST(VariogramFit, of_an_exponential_model_keeps_to_it) {
  const VariogramModel truth{Shape::stable, 0.1, 0.8, 20, 1};
  const VariogramModel fit = fit_exponential(classes_of(truth));
  EXPECT_EQ(fit.exponent, 1);
  for (double distance = 1; distance < 200; distance *= 1.7)
    EXPECT_NEAR(fit(distance), truth(distance), 4e-3 * truth(distance));
  const VariogramModel other{Shape::spherical, 0.1, 0.8, 60, 1};
  const VariogramModel near = fit_exponential(classes_of(other));
  EXPECT_EQ(near.shape, Shape::stable);
  EXPECT_EQ(near.exponent, 1);
}

}  // namespace
}  // namespace thiessen
