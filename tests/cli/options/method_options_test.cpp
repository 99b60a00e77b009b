#include "cli/options/method_options.h"

#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct Method : Given<MethodOptions> {
  Method() { block.declare(options); }
};

using Methods = std::vector<RainMethod>;

TEST(MethodOptions, are_thiessens_unless_told) {
  Method method;
  method.read({});
  EXPECT_EQ(method.block.methods(), Methods{RainMethod::thiessen});
  EXPECT_EQ(method.block.points(), 2000U);
  EXPECT_EQ(method.contradiction(), "");
}

TEST(MethodOptions, know_every_method_by_the_name_that_it_gives_itself_and_all_of_them) {
  for (const RainMethod wanted : all_methods) {
    Method method;
    method.read({"--method", name_of(wanted)});
    EXPECT_EQ(method.block.methods(), Methods{wanted});
  }
  Method all;
  all.read({"--method", "all"});
  EXPECT_EQ(all.block.methods(), Methods(all_methods.begin(), all_methods.end()));
  EXPECT_NE(Method().refusal({"--method", "kriging"}), "");
}

// A grid of points is of use to methods that are means over points.
TEST(MethodOptions, law_1_points_go_with_methods_that_average_them) {
  for (const RainMethod wanted : all_methods) {
    Method method;
    method.read({"--method", name_of(wanted), "--grid", "500"});
    EXPECT_EQ(method.block.points(), 500U);
    EXPECT_EQ(method.contradiction().empty(), averages_points(wanted)) << name_of(wanted);
  }
  Method all;
  all.read({"--method", "all", "--grid", "1"});
  EXPECT_EQ(all.contradiction(), "");
  Method none;
  none.read({"--grid", "500"});
  EXPECT_EQ(none.contradiction(), "--grid is about --method idw, natural or all");
  EXPECT_NE(Method().refusal({"--grid", "0"}), "");
  EXPECT_NE(Method().refusal({"--grid", "100001"}), "");
}

}  // namespace
}  // namespace thiessen::cli
