#include "map/sheet/map_detail.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(MapDetail, outlines_give_way_where_they_would_cover_what_they_part) {
  MapDetail detail;
  thin_out(detail, 1000, 100, 1000 * 10 * 10);
  EXPECT_TRUE(detail.has_cell_outlines && detail.has_basin_outlines);
  thin_out(detail, 1000, 100, 1000 * 4 * 4);
  EXPECT_FALSE(detail.has_cell_outlines) << "cells of 4 x 4 pixels";
  EXPECT_TRUE(detail.has_basin_outlines) << "basins of 12 x 12";
  thin_out(detail, 1000, 100, 100 * 4 * 4);
  EXPECT_FALSE(detail.has_basin_outlines);
  EXPECT_TRUE(detail.has_gauges && detail.has_labels);
}

TEST(MapDetail, a_single_cell_or_basin_is_outlined_however_small) {
  MapDetail detail;
  thin_out(detail, 1, 1, 2);
  EXPECT_TRUE(detail.has_cell_outlines && detail.has_basin_outlines);
}

}  // namespace
}  // namespace thiessen
