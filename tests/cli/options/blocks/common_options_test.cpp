#include "cli/options/blocks/common_options.h"

#include "base/parallel.h"
#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct Common : Given<CommonOptions> {
  Common() { block.declare(options); }
};

TEST(CommonOptions, use_all_cores_and_are_not_quiet_unless_told) {
  Common common;
  common.read({});
  EXPECT_EQ(common.block.threads, available_threads());
  EXPECT_GE(common.block.threads, 1U);
  EXPECT_FALSE(common.block.quiet);
}

TEST(CommonOptions, take_as_many_threads_as_told) {
  Common common;
  common.read({"--threads", "3", "-q"});
  EXPECT_EQ(common.block.threads, 3U);
  EXPECT_TRUE(common.block.quiet);
  for (const char* wrong : {"0", "1025", "-1", "1.5", "all"})
    EXPECT_NE(Common().refusal({"--threads", wrong}), "") << wrong;
}

}  // namespace
}  // namespace thiessen::cli
