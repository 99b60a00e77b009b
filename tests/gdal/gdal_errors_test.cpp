#include "gdal/gdal_errors.h"

#include <cpl_error.h>
#include <gtest/gtest.h>

#include "base/memory.h"

namespace thiessen {
namespace {

TEST(GdalErrors, keep_the_first_error_and_print_nothing) {
  testing::internal::CaptureStderr();
  const GdalErrors errors;
  EXPECT_FALSE(errors.failed());
  CPLError(CE_Failure, CPLE_AppDefined, "first");
  CPLError(CE_Failure, CPLE_AppDefined, "second");
  EXPECT_TRUE(errors.failed());
  EXPECT_EQ(errors.text(), "first");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(GdalErrors, tell_a_warning_only_where_there_is_no_error) {
  const GdalErrors errors;
  EXPECT_EQ(errors.text(), "GDAL gives no reason");
  CPLError(CE_Warning, CPLE_AppDefined, "odd");
  CPLError(CE_Warning, CPLE_AppDefined, "odder");
  EXPECT_FALSE(errors.failed());
  EXPECT_EQ(errors.text(), "odd");
  EXPECT_EQ(errors.warnings(), (std::vector<std::string>{"odd", "odder"}));
  CPLError(CE_Failure, CPLE_AppDefined, "wrong");
  EXPECT_EQ(errors.text(), "wrong");
}

TEST(GdalErrors, are_sentences_of_one_line_without_a_full_stop) {
  const GdalErrors errors;
  CPLError(CE_Failure, CPLE_AppDefined, "line one.\nline two. .. ");
  EXPECT_EQ(errors.text(), "line one. line two");
}

TEST(GdalErrors, note_a_lack_of_memory_that_GDAL_goes_on_after) {
  forget_lack_of_memory();
  const GdalErrors errors;
  CPLError(CE_Failure, CPLE_AppDefined, "wrong");
  EXPECT_FALSE(has_lacked_memory());
  CPLError(CE_Warning, CPLE_OutOfMemory, "no room");
  EXPECT_TRUE(has_lacked_memory());
  forget_lack_of_memory();
}

TEST(GdalErrors, may_be_cleared) {
  GdalErrors errors;
  CPLError(CE_Failure, CPLE_AppDefined, "wrong");
  CPLError(CE_Warning, CPLE_AppDefined, "odd");
  errors.clear();
  EXPECT_FALSE(errors.failed());
  EXPECT_TRUE(errors.warnings().empty());
  CPLError(CE_Failure, CPLE_AppDefined, "wrong again");
  EXPECT_EQ(errors.text(), "wrong again");
}

TEST(GdalErrors, the_innermost_hears_and_leaves_nothing_behind) {
  const GdalErrors outer;
  {
    const GdalErrors inner;
    CPLError(CE_Failure, CPLE_AppDefined, "within");
    EXPECT_EQ(inner.text(), "within");
  }
  EXPECT_FALSE(outer.failed());
  EXPECT_STREQ(CPLGetLastErrorMsg(), "");
  CPLError(CE_Failure, CPLE_AppDefined, "after");
  EXPECT_EQ(outer.text(), "after");
}

}  // namespace
}  // namespace thiessen
