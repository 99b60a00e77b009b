#include "cli/options/blocks/what_if_options.h"

#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct WhatIf : Given<WhatIfOptions> {
  WhatIf() { block.declare(options); }
};

TEST(WhatIfOptions, change_nothing_unless_told) {
  WhatIf what_if;
  what_if.read({});
  EXPECT_FALSE(what_if.block.given());
  EXPECT_EQ(what_if.contradiction(), "");
}

TEST(WhatIfOptions, close_gauges_by_their_ids_and_open_others_in_their_order) {
  WhatIf what_if;
  what_if.read({"--with", "1,2", "--without", "B", "--without", "A", "--with=-3.5,4"});
  EXPECT_TRUE(what_if.block.given());
  EXPECT_EQ(what_if.block.closed(), (std::vector<std::string>{"B", "A"}));
  EXPECT_EQ(what_if.block.opened(), (std::vector<Point>{{1, 2}, {-3.5, 4}}));
  EXPECT_NE(WhatIf().refusal({"--with", "1"}), "");
}

TEST(WhatIfOptions, close_a_gauge_once) {
  WhatIf twice;
  twice.read({"--without", "A", "--without", "B", "--without", "A"});
  EXPECT_EQ(twice.contradiction(), "--without names station 'A' twice");
  WhatIf alike;
  alike.read({"--without", "A", "--without", "a", "--without", " A"});
  EXPECT_EQ(alike.contradiction(), "") << "ids are texts";
}

TEST(WhatIfOptions, may_open_gauges_at_one_place) {
  WhatIf what_if;
  what_if.read({"--with", "1,2", "--with", "1,2"});
  EXPECT_EQ(what_if.contradiction(), "");
  EXPECT_EQ(what_if.block.opened().size(), 2U);
}

}  // namespace
}  // namespace thiessen::cli
