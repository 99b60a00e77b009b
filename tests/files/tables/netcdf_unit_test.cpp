// Units as UDUNITS writes them.
#include "files/tables/netcdf_unit.h"

#include <gtest/gtest.h>

#include "readings/units/rain_unit.h"

namespace thiessen {
namespace {

TEST(NetcdfUnit, has_quotients_in_place_of_powers) {
  EXPECT_EQ(udunits_with_quotients("mm h-1"), "mm/h");
  EXPECT_EQ(udunits_with_quotients("m s-1"), "m/s");
  EXPECT_EQ(udunits_with_quotients("kg m-2"), "kg/m2");
  EXPECT_EQ(udunits_with_quotients("kg m-2 s-1"), "kg/m2/s");
  EXPECT_EQ(udunits_with_quotients("kg.m^-2.s^-1"), "kg/m2/s");
  EXPECT_EQ(udunits_with_quotients("kg*m**-2 s**-1"), "kg/m2/s");
  EXPECT_EQ(udunits_with_quotients("mm  day^-1"), "mm/day");
}

TEST(NetcdfUnit, leaves_others_as_they_are) {
  for (const char* other : {"mm", "mm/day", "0.1 mm", "1", "", "inches", "kg/m2", "h-1", "mm/3h"})
    EXPECT_EQ(udunits_with_quotients(other), other);
}

TEST(NetcdfUnit, is_read_as_a_unit_of_rain) {
  EXPECT_EQ(rain_unit(udunits_with_quotients("mm h-1"))->name(), "mm/h");
  EXPECT_EQ(rain_unit(udunits_with_quotients("mm d^-1"))->name(), "mm/day");
  EXPECT_EQ(rain_unit(udunits_with_quotients("kg m-2"))->name(), "mm");
}

}  // namespace
}  // namespace thiessen
