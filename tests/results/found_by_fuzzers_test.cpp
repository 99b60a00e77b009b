// What fuzzers found in results/, numbered on from room to room.
#include <gtest/gtest.h>

#include <string>

#include "outlines/vertex_rounding.h"
#include "results/cell_features.h"
#include "results/cells_geojson.h"
#include "results/provenance.h"

namespace thiessen {
namespace {

// 07 is a number to us, and none to JSON.
TEST(CellsGeojson, finding_10_writes_a_unit_as_a_text_whatever_it_is) {
  CellFeatures features;
  features.made_by.emplace();
  features.made_by->tolerance = 0.5;
  features.made_by->unit = "07";
  const std::string text = cells_geojson(features, {}, VertexRounding());
  EXPECT_NE(text.find(R"("tolerance":0.5,"unit":"07"})"), std::string::npos) << text;
}

}  // namespace
}  // namespace thiessen
