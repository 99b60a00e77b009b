#include "rainfall/errors/field_parts.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

#include "basin/shapes.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/normals/plane_raster.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

/// Two gauges, each with half of a basin of 8 by 4. The means of the halves are 2 and 6, and the
/// gauges' pixels have 2.5 and 8.
struct TwoHalves {
  Network network{{{"a", {2, 2}, 2}, {"b", {6, 2}, 3}}, Metric::planar};
  std::vector<Basin> basins{shapes::basin({{shapes::rectangle({0, 0}, {8, 4}), {}}})};
  Weighing weighing{network, basins, {Metric::planar, 1, 0.1}};

  explicit TwoHalves(bool with_normals) {
    if (!with_normals) return;
    constexpr double columns[] = {1, 2, 2.5, 2.5, 5, 5, 8, 6};
    weighing.take_normals(plane_raster::normals_of(
        {8, 4, [=](double x, double, std::size_t) { return columns[static_cast<int>(x)]; }},
        network, basins));
  }
  FieldParts parts(Gaps gaps) const {
    return {std::make_shared<const ArealRainfall>(weighing, ArealRainfallSettings{gaps}, 1),
            weighing,
            {}};
  }
};

// 0.5 x 0.8 x 2.5 / 4 and 0.5 x 0.75 x 8 / 4; the first station's normal is 2.5.
TEST(FieldParts, with_normals_are_weight_times_factor_times_normal_over_that_of_the_basin) {
  const TwoHalves study(true);
  const FieldParts parts = study.parts(Gaps::retessellate);
  EXPECT_DOUBLE_EQ(parts.normal(0), 4 / 2.5);
  EXPECT_EQ(parts.error_of_normal(0), 0);
  const auto full = parts.full();
  ASSERT_EQ(full.size(), 2u);
  EXPECT_DOUBLE_EQ(full[0].weight, 0.25);
  EXPECT_DOUBLE_EQ(full[1].weight, 0.75);
}

// The readings are those divided by normals relative to the first station's. Retessellated, gauge a
// has the whole basin; renormalised it has 1 x 0.8 x 2.5 / 4 of it.
TEST(FieldParts, of_a_step_change_where_a_gauge_is_silent) {
  const TwoHalves study(true);
  for (const auto& [gaps, part] : {std::pair{Gaps::retessellate, 1.0}, {Gaps::renormalise, 0.5}}) {
    const FieldParts parts = study.parts(gaps);
    CellAccount account;
    const auto all = parts.at(std::vector<double>{10, 16}, account);
    EXPECT_TRUE(account.change.empty());
    EXPECT_DOUBLE_EQ(account.readings[1], 5);
    EXPECT_DOUBLE_EQ(all[0].rainfall, 4 + 6);
    const auto one = parts.at(std::vector<double>{10, silent}, account);
    EXPECT_DOUBLE_EQ(one[0].rainfall, part * 16);
    ASSERT_EQ(account.change.size(), 2u);
    EXPECT_NEAR(account.change[0].weight, part - 0.25, 1e-14);
    EXPECT_DOUBLE_EQ(account.change[1].weight, -0.75);
  }
}

TEST(FieldParts, without_normals_are_the_weights) {
  const TwoHalves study(false);
  const FieldParts parts = study.parts(Gaps::retessellate);
  EXPECT_FALSE(parts.has_normals());
  EXPECT_EQ(parts.normal(0), 1);
  EXPECT_EQ(parts.full()[0].weight, 0.5);
  CellAccount account;
  parts.at(std::vector<double>{10, 16}, account);
  EXPECT_EQ(account.readings, (std::vector<double>{10, 16}));
}

}  // namespace
}  // namespace thiessen
