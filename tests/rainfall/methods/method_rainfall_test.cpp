#include "rainfall/methods/method_rainfall.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "rainfall/methods/method_study.h"

namespace thiessen {
namespace {

using namespace by_method;

TEST(SeveralMethods, come_basin_by_basin) {
  const Study study = textbook_study();
  std::vector<std::unique_ptr<const StepRainfall>> methods;
  methods.push_back(std::make_unique<const MethodRainfall>(
      study.weighing, arithmetic(study.weighing), ArealRainfallSettings{}));
  methods.push_back(
      std::make_unique<const ArealRainfall>(study.weighing, ArealRainfallSettings{}, 1));
  const SeveralMethods several(std::move(methods));
  const auto values = several.at(textbook::readings());
  ASSERT_EQ(values.size(), 2u);
  EXPECT_NEAR(values[0].rainfall, 69.2, 1e-12);
  EXPECT_NEAR(values[1].rainfall, 69.836427036902, 1e-12);
}

}  // namespace
}  // namespace thiessen
