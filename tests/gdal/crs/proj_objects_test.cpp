#include "gdal/crs/proj_objects.h"

#include <gtest/gtest.h>
#include <stdlib.h>

namespace thiessen {
namespace {

TEST(ProjObjects, a_context_is_quiet_and_fetches_nothing_whatever_the_environment_says) {
  setenv("PROJ_NETWORK", "ON", 1);
  setenv("PROJ_DEBUG", "3", 1);
  testing::internal::CaptureStderr();
  const ProjContext context = quiet_context();
  EXPECT_EQ(proj_context_is_network_enabled(context.get()), 0);
  EXPECT_EQ(ProjObject(proj_create(context.get(), "+proj=nonsense")), nullptr);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  unsetenv("PROJ_NETWORK");
  unsetenv("PROJ_DEBUG");
}

TEST(ProjObjects, the_database_is_there) {
  EXPECT_NO_THROW(require_proj_database());
}

}  // namespace
}  // namespace thiessen
