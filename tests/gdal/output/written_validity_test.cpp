// What formats that round coordinates make of shapes.
#include "gdal/output/written_validity.h"

#include <gtest/gtest.h>

#include "base/temporary_folder.h"

namespace thiessen {
namespace {

std::optional<WrittenFault> fault_of(const std::string& rows, const std::string& driver) {
  const TemporaryFolder folder;
  return fault_after_rounding(folder.write("cells.csv", "WKT,station\n" + rows), driver);
}

TEST(WrittenValidity, finds_nothing_in_valid_shapes) {
  EXPECT_FALSE(fault_of("\"POLYGON((0 0,4 0,4 4,0 0))\",a\n", "CSV"));
}

TEST(WrittenValidity, finds_the_first_shape_that_is_not_valid) {
  const auto fault = fault_of(
      "\"POLYGON((0 0,4 0,4 4,0 0))\",a\n\"MULTIPOLYGON(((0 0,4 4,4 0,0 4,0 0)))\",b\n", "CSV");
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->feature, 1U);
  EXPECT_EQ(fault->reason, "self-intersection at or near point 2 2");
}

TEST(WrittenValidity, passes_over_formats_that_keep_doubles) {
  EXPECT_FALSE(fault_of("\"POLYGON((0 0,4 4,4 0,0 4,0 0))\",b\n", "GPKG"));
}

}  // namespace
}  // namespace thiessen
