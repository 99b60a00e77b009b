#include "map/raster/surface_rows.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace thiessen {
namespace {

/// Counts how often all surfaces were asked and begun anew.
struct Calls {
  std::atomic<int> asked = 0;
  std::atomic<int> begun = 0;
  std::atomic<int> made = 0;
};

/// x + 10 y, among the gauges west of 3; beyond them it goes on with the other sign.
class Slope : public RainSurface {
 public:
  explicit Slope(Calls& calls) : calls_(calls) { ++calls.made; }
  Value at(Point p) override {
    ++calls_.asked;
    return {p.x + 10 * p.y, p.x < 3};
  }
  Value continued(Point p) override {
    const Value value = at(p);
    return {value.is_among_gauges ? value.rainfall : -value.rainfall, value.is_among_gauges};
  }
  void begin_anew() override { ++calls_.begun; }

 private:
  Calls& calls_;
};

// Six pixels in each of three rows; the centres are from (0.5, 2.5) to (5.5, 0.5).
const PixelGrid grid{{0, 3}, 1, 6, 3};

PointMapping as_it_is() {
  return [](std::vector<Point>&) {};
}

std::vector<float> rows_of(Calls& calls, SurfaceRows::Beyond beyond, int row, int count,
                           const std::vector<std::int32_t>& is_inside = {}, unsigned threads = 1) {
  SurfaceRows rows(
      grid, beyond, [&] { return std::make_unique<Slope>(calls); }, as_it_is, threads);
  const auto values = rows.rows(row, count, is_inside);
  return {values.begin(), values.end()};
}

TEST(SurfaceRows, have_the_values_at_the_pixels_centres_from_the_north) {
  Calls calls;
  const auto values = rows_of(calls, SurfaceRows::Beyond::nearest, 0, 3);
  ASSERT_EQ(values.size(), 18U);
  EXPECT_EQ(values[0], 25.5F);
  EXPECT_EQ(values[5], 30.5F);
  EXPECT_EQ(values[6], 15.5F);
  EXPECT_EQ(values[17], 10.5F);
  const auto last = rows_of(calls, SurfaceRows::Beyond::nearest, 2, 1);
  ASSERT_EQ(last.size(), 6U);
  EXPECT_EQ(last[0], 5.5F);
}

TEST(SurfaceRows, go_on_beyond_the_gauges_where_that_is_wanted) {
  Calls calls;
  const auto values = rows_of(calls, SurfaceRows::Beyond::continued, 0, 1);
  EXPECT_EQ(values[2], 27.5F);
  EXPECT_EQ(values[3], -28.5F);
}

TEST(SurfaceRows, know_their_range_among_the_gauges) {
  for (const auto beyond : {SurfaceRows::Beyond::nearest, SurfaceRows::Beyond::continued}) {
    Calls calls;
    SurfaceRows rows(
        grid, beyond, [&] { return std::make_unique<Slope>(calls); }, as_it_is, 2);
    EXPECT_FALSE(rows.range_among_gauges());
    rows.rows(0, 2, std::vector<std::int32_t>{0, 1, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1});
    ASSERT_TRUE(rows.range_among_gauges());
    EXPECT_EQ(rows.range_among_gauges()->least, 26.5);
    EXPECT_EQ(rows.range_among_gauges()->largest, 26.5);
    const auto among = rows.are_among_gauges();
    EXPECT_EQ(std::vector<int>(among.begin(), among.end()),
              (std::vector<int>{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    rows.rows(1, 2, {});
    EXPECT_EQ(rows.range_among_gauges()->least, 5.5);
    EXPECT_EQ(rows.range_among_gauges()->largest, 26.5);
  }
}

TEST(SurfaceRows, have_none_outside_where_the_surface_is_not_even_asked) {
  Calls calls;
  const auto values =
      rows_of(calls, SurfaceRows::Beyond::nearest, 1, 2, {0, 0, 7, 0, 0, 0, 1, 0, 0, 0, 0, 2});
  EXPECT_EQ(calls.asked, 3);
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(std::isnan(values[i]), i != 2 && i != 6 && i != 11) << i;
  EXPECT_EQ(values[2], 17.5F);
  EXPECT_EQ(values[11], 10.5F);
}

TEST(SurfaceRows, have_none_where_the_projection_ends) {
  Calls calls;
  SurfaceRows rows(
      grid, SurfaceRows::Beyond::nearest, [&] { return std::make_unique<Slope>(calls); },
      [] {
        return [](std::vector<Point>& points) {
          for (Point& p : points) {
            if (p.x > 4) p.x = std::numeric_limits<double>::quiet_NaN();
            if (p.x < 1) p.y = std::numeric_limits<double>::infinity();
            p.x *= 2;
          }
        };
      },
      1);
  const auto values = rows.rows(0, 1, {});
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_EQ(values[1], 28.0F) << "at 3, where the study has it";
  EXPECT_TRUE(std::isnan(values[4]));
  EXPECT_EQ(calls.asked, 3);
}

TEST(SurfaceRows, law_1_do_not_depend_on_the_threads_for_each_row_begins_anew) {
  Calls calls;
  const auto one = rows_of(calls, SurfaceRows::Beyond::nearest, 0, 3);
  EXPECT_EQ(calls.begun, 3);
  EXPECT_EQ(calls.made, 1);
  EXPECT_EQ(rows_of(calls, SurfaceRows::Beyond::nearest, 0, 3, {}, 3), one);
  EXPECT_EQ(calls.begun, 6);
  EXPECT_LE(calls.made, 4) << "one a thread";
  EXPECT_EQ(rows_of(calls, SurfaceRows::Beyond::nearest, 0, 3, {}, 0), one) << "at least one";
}

}  // namespace
}  // namespace thiessen
