#include "rainfall/errors/variogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

using Shape = VariogramModel::Shape;

std::vector<VariogramModel> models() {
  std::vector<VariogramModel> all;
  for (const double exponent : {0.25, 0.7, 1.0, 1.6, 2.0})
    all.push_back({Shape::stable, 0.1, 0.9, 3, exponent});
  all.push_back({Shape::spherical, 0.2, 0.7, 5, 1});
  all.push_back({Shape::stable, 0.3, 0, 1, 1});
  return all;
}

TEST(VariogramModel, is_what_is_written) {
  const VariogramModel exponential{Shape::stable, 0.1, 0.9, 2, 1};
  EXPECT_NEAR(exponential(3), 0.1 + 0.9 * (1 - std::exp(-1.5)), 1e-15);
  const VariogramModel gaussian{Shape::stable, 0, 1, 2, 2};
  EXPECT_NEAR(gaussian(3), 1 - std::exp(-2.25), 1e-15);
  const VariogramModel spherical{Shape::spherical, 0.5, 2, 4, 1};
  EXPECT_NEAR(spherical(2), 0.5 + 2 * (0.75 - 0.0625), 1e-15);
  EXPECT_EQ(spherical(4), 2.5);
  EXPECT_EQ(spherical(9), 2.5);
}

TEST(Variogram, is_its_model_to_five_millionths) {
  Seeded seeded;
  for (const VariogramModel& model : models()) {
    const Variogram table(model, 100);
    for (int i = 0; i < 20'000; ++i) {
      const double distance = std::pow(10, seeded.uniform(-3.9, 2.5));  // and beyond the longest
      const double exact = model(distance);
      ASSERT_NEAR(table.at_square(distance * distance), exact, 5e-6 * exact) << distance;
    }
    EXPECT_EQ(table.at_square(0), model.nugget);
    EXPECT_GE(table.at_square(1e-12), model.nugget);
    EXPECT_LE(table.at_square(1e-12), table.at_square(1e-7) + 1e-15);
  }
}

// Law: a sum of readings with weights that add up to 0 has a mean square, -w'Gw, that is not
// negative.
TEST(Variogram, is_valid_in_space) {
  Seeded seeded;
  for (const VariogramModel& model : models()) {
    const Variogram table(model, 20);
    for (int round = 0; round < 200; ++round) {
      std::vector<Direction> points;
      std::vector<double> weights;
      double sum = 0;
      for (int i = 0; i < 12; ++i) {
        points.push_back({seeded.uniform(0, 10), seeded.uniform(0, 10), seeded.uniform(0, 3)});
        weights.push_back(seeded.uniform(-1, 1));
        sum += weights.back();
      }
      double square = 0;
      for (std::size_t i = 0; i < 12; ++i) {
        for (std::size_t j = 0; j < 12; ++j) {
          if (i != j)
            square -=
                (weights[i] - sum / 12) * (weights[j] - sum / 12) * table(points[i], points[j]);
        }
      }
      ASSERT_GT(square, -1e-5);  // the table's own accuracy, for 144 terms
    }
  }
}

}  // namespace
}  // namespace thiessen
