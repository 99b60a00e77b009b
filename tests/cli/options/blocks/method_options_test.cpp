#include "cli/options/blocks/method_options.h"

#include "cli/options/given_options.h"
#include "cli/options/named_enumerators.h"

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
  EXPECT_EQ(method.block.points().points, 2000U);
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

// A method that neither all_methods nor the list of the option has would compile, and nobody could
// ask for it.
TEST(MethodOptions, offer_every_method_that_there_is) {
  const Method method;
  std::vector<std::string> names = names_of_enumerators<RainMethod>(name_of);
  names.emplace_back("all");
  EXPECT_EQ(method.options.at("--method").value.choices, names);
}

TEST(MethodOptions, take_several_parted_by_commas_and_isohyets_beside_all) {
  Method some;
  some.read({"--method", "natural,isohyetal,thiessen"});
  EXPECT_EQ(some.block.methods(),
            (Methods{RainMethod::natural, RainMethod::isohyetal, RainMethod::thiessen}));
  EXPECT_TRUE(some.block.has_isohyets());
  Method more;
  more.read({"--method", "all,isohyetal"});
  EXPECT_EQ(more.block.methods().size(), all_methods.size() + 1);
  for (const char* wrong : {"idw,idw", "idw,", "all,natural", ",", "idw,kriging"})
    EXPECT_NE(Method().refusal({"--method", wrong}), "") << wrong;
}

TEST(MethodOptions, an_interval_goes_with_isohyets) {
  Method interval;
  interval.read({"--interval", "5"});
  EXPECT_EQ(interval.contradiction(), "--interval is about --method isohyetal");
  Method isohyets;
  isohyets.read({"--interval", "5", "--method", "isohyetal"});
  EXPECT_EQ(isohyets.contradiction(), "");
  EXPECT_EQ(isohyets.block.points().interval, 5);
}

TEST(MethodOptions, that_weigh_gauges_have_standard_errors) {
  for (const char* name : {"thiessen", "arithmetic", "all", "thiessen,idw"}) {
    Method method;
    method.read({"--method", name});
    EXPECT_NO_THROW(method.block.check_errors()) << name;
  }
  for (const char* name : {"isohyetal", "thiessen,isohyetal"}) {
    Method isohyets;
    isohyets.read({"--method", name});
    EXPECT_THROW(isohyets.block.check_errors(), UsageError) << name;
  }
}

// A grid of points is of use to methods that are means over points.
TEST(MethodOptions, law_1_points_go_with_methods_that_average_them) {
  for (const RainMethod wanted : all_methods) {
    Method method;
    method.read({"--method", name_of(wanted), "--grid", "500"});
    EXPECT_EQ(method.block.points().points, 500U);
    EXPECT_EQ(method.contradiction().empty(), averages_points(wanted)) << name_of(wanted);
  }
  Method all;
  all.read({"--method", "all", "--grid", "1"});
  EXPECT_EQ(all.contradiction(), "");
  Method none;
  none.read({"--grid", "500"});
  EXPECT_EQ(none.contradiction(), "--grid is about --method idw, natural, isohyetal or all");
  EXPECT_NE(Method().refusal({"--grid", "0"}), "");
  EXPECT_NE(Method().refusal({"--grid", "100001"}), "");
}

}  // namespace
}  // namespace thiessen::cli
