#include "readings/units/rain_unit.h"

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

TEST(RainUnit, may_be_a_rate_in_several_spellings) {
  for (const char* text : {"mm/h", "mm/hr", "mm h-1", "mm hr-1", "mm per hour", "MM / Hour",
                           "mmh\u207b\u00b9", "mm/60min", "kg m-2 h-1", "l/m\u00b2/h"})
    EXPECT_EQ(rain_unit(text)->name(), "mm/h") << text;
  for (const char* text : {"mm/day", "mm d-1", "mm/24h", "mm day-1", "mm per day"})
    EXPECT_EQ(rain_unit(text)->name(), "mm/day") << text;
  EXPECT_EQ(rain_unit("inches per 15 minutes")->name(), "in/15min");
  EXPECT_EQ(rain_unit("kg m-2 s-1")->name(), "mm/s");
  EXPECT_EQ(rain_unit("mm/month")->name(), "mm/month");
  EXPECT_EQ(rain_unit("cm/a")->name(), "cm/year");
  EXPECT_EQ(rain_unit("mm/10")->name(), "0.1mm") << "tenths, and no time";
  for (const char* other : {"mm/7h", "mms", "mmin", "m/", "mm/99999999999999999999h", "mm1"})
    EXPECT_FALSE(rain_unit(other)) << other;
}

TEST(RainUnit, tells_the_time_of_a_rate) {
  EXPECT_EQ(time_of_rate(*rain_unit("mm/15min")), (StepLength{0, 900}));
  EXPECT_EQ(time_of_rate(*rain_unit("in/day")), (StepLength{0, 86'400}));
  EXPECT_EQ(time_of_rate(*rain_unit("mm/year")), (StepLength{12, 0}));
  EXPECT_FALSE(time_of_rate(*rain_unit("mm")));
}

TEST(RainUnit, is_taken_from_a_rate_to_another) {
  EXPECT_EQ(factor_between(*rain_unit("mm/s"), *rain_unit("mm/h")).of(0.5), 1800);
  EXPECT_EQ(factor_between(*rain_unit("in/h"), *rain_unit("mm/h")).of(2), 50.8);
}

TEST(RainUnit, has_a_depth_in_a_length_of_time) {
  EXPECT_EQ(depth_unit("mm/h"), "mm");
  EXPECT_EQ(depth_unit("inches per day"), "in");
  EXPECT_EQ(depth_unit("mm"), "mm");
  EXPECT_EQ(depth_unit("buckets"), "buckets");
  EXPECT_EQ(depth_unit(""), "");
}

TEST(RainUnit, may_stand_in_a_line_above_a_header) {
  const auto told = [](std::string_view line) {
    const auto unit = unit_in_line(line);
    return unit ? unit->name() : "none";
  };
  for (const char* line : {"Unit: inches", "# units: inches", "Units,in,,", "# UNIT = Inches",
                           "units: inches (in)", "Daily rainfall in inches", "\"Rainfall [in]\"",
                           "Precipitation, inches", "# Rainfall (inches)"})
    EXPECT_EQ(told(line), "in") << line;
  EXPECT_EQ(told("rain:  -  Precipitation Amount (mm)"), "mm");
  EXPECT_EQ(told("Rain intensity in mm/h"), "mm/h");
  for (const char* line :
       {"", "#", "Station: 12", "Unit 5, hydrology", "units: m", "units: degC", "Elevation (ft)",
        "Rainfall in Ireland", "Height in mm", "rain gauge (5)"})
    EXPECT_EQ(told(line), "none") << line;
}

}  // namespace
}  // namespace thiessen
