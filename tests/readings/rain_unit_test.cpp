#include "readings/rain_unit.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace thiessen {
namespace {

std::string unit_named(std::string_view column) {
  const auto unit = unit_in_name(column);
  return unit ? unit->name() : "none";
}

TEST(RainUnit, is_known_in_several_spellings) {
  EXPECT_EQ(rain_unit("Inches")->name(), "in");
  EXPECT_EQ(rain_unit("0.1 mm")->name(), "0.1mm");
  EXPECT_EQ(rain_unit("tenths of mm")->name(), "0.1mm");
  EXPECT_EQ(rain_unit("hundredths of an inch")->name(), "0.01in");
  EXPECT_EQ(rain_unit("kg/m2")->name(), "mm") << "a litre of water weighs a kilogram";
  EXPECT_EQ(rain_unit("mm/hr")->name(), "mm/h");
  EXPECT_EQ(rain_unit("in_d")->name(), "in/day");
  for (const char* other : {"", "h", "day", "K", "hPa", "mmm"}) EXPECT_FALSE(rain_unit(other));
}

TEST(RainUnit, ends_the_name_of_a_column) {
  EXPECT_EQ(unit_named("prcp_in"), "in");
  EXPECT_EQ(unit_named(" Rain (mm) "), "mm");
  EXPECT_EQ(unit_named("rainfall [cm]"), "cm");
  EXPECT_EQ(unit_named("p (0.1 mm)"), "0.1mm");
  EXPECT_EQ(unit_named("rain_l_m2"), "mm");
  EXPECT_EQ(unit_named("tp_m"), "m") << "as reanalyses have it";
  EXPECT_EQ(unit_named("catch_mm"), "mm");
  EXPECT_EQ(unit_named("catch (m)"), "m");
}

TEST(RainUnit, is_not_read_into_other_names) {
  for (const char* name : {"rain", "prcp", "min", "rain_min", "p_5", "elev_m", "depth_ft", "mm", "",
                           "rain (gauge 5)", "rain)"})
    EXPECT_EQ(unit_named(name), "none") << name;
}

// An inch is 25.4 mm by definition; each quotient is the double nearest to the true one.
TEST(RainUnit, is_taken_to_another_as_near_as_doubles_can_be) {
  const auto convert = [](const char* from, const char* to, double amount) {
    return factor_between(*rain_unit(from), *rain_unit(to)).of(amount);
  };
  EXPECT_EQ(convert("in", "mm", 2), 50.8);
  EXPECT_EQ(convert("0.1mm", "mm", 1754), 175.4);
  EXPECT_EQ(convert("0.01in", "mm", 123), 31.242);
  EXPECT_EQ(convert("0.01in", "in", 123), 1.23);
  EXPECT_EQ(convert("mm", "in", 25.4), 1);
  EXPECT_EQ(convert("m", "cm", 0.5), 50);
  EXPECT_EQ(convert("ft", "in", 3), 36);
  EXPECT_TRUE(factor_between(*rain_unit("l/m2"), *rain_unit("mm")).is_one());
}

}  // namespace
}  // namespace thiessen
