#include "results/cell_features.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(CellFeatures, an_attribute_whose_name_is_taken_gets_underscores_case_ignored) {
  Attributes attributes;
  attributes.fields = {{"Weight", FieldType::real},
                       {"basin", FieldType::text},
                       {"weight_", FieldType::text},
                       {"height", FieldType::integer}};
  CellFeatures features;
  features.attributes = &attributes;
  const auto fields = attribute_fields(features);
  ASSERT_EQ(fields.size(), 4U);
  EXPECT_EQ(fields[0].name, "Weight_");
  EXPECT_EQ(fields[1].name, "basin_");
  EXPECT_EQ(fields[2].name, "weight__");
  EXPECT_EQ(fields[3].name, "height");
  EXPECT_EQ(fields[0].type, FieldType::real);
}

TEST(CellFeatures, an_attribute_is_not_called_as_the_shapes_are) {
  Attributes attributes;
  attributes.fields = {{"geom", FieldType::text}, {"GEOM_", FieldType::text}};
  CellFeatures features;
  features.attributes = &attributes;
  EXPECT_EQ(attribute_fields(features)[0].name, "geom");
  features.geometry_column = "geom";
  const auto fields = attribute_fields(features);
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(fields[0].name, "geom_");
  EXPECT_EQ(fields[1].name, "GEOM__");
}

TEST(CellFeatures, without_attributes_there_are_no_fields_of_theirs) {
  EXPECT_TRUE(attribute_fields({}).empty());
}

}  // namespace
}  // namespace thiessen
