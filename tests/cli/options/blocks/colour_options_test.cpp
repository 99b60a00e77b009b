#include "cli/options/blocks/colour_options.h"

#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct Colours : Given<ColourOptions> {
  Colours() { block.declare(options); }
};

TEST(ColourOptions, let_the_readings_choose_unless_told) {
  Colours colours;
  colours.read({});
  EXPECT_EQ(colours.block.rule.kind, ClassRule::Kind::chosen);
  EXPECT_EQ(colours.block.rule.palette, Palette::viridis);
  EXPECT_FALSE(colours.block.rule.range);
  EXPECT_EQ(colours.contradiction(false), "");
}

TEST(ColourOptions, take_what_they_are_told) {
  Colours breaks;
  breaks.read({"--breaks", "0.5,2,10", "--palette", "greys"});
  EXPECT_EQ(breaks.block.rule.kind, ClassRule::Kind::breaks);
  EXPECT_EQ(breaks.block.rule.breaks, (std::vector<double>{0.5, 2, 10}));
  EXPECT_EQ(breaks.block.rule.palette, Palette::greys);
  Colours words;
  words.read({"--breaks", "quantile"});
  EXPECT_EQ(words.block.rule.kind, ClassRule::Kind::quantiles);
  Colours range;
  range.read({"--range", "0,50", "--breaks", "equal"});
  EXPECT_EQ(range.block.rule.range->high, 50);
  EXPECT_EQ(range.contradiction(true), "");
}

TEST(ColourOptions, refuse_what_is_no_classes) {
  for (const char* wrong : {"", ",", "1,", "2,1", "1,1", "a", "1;2", "nan,2"}) {
    EXPECT_EQ(Colours().refusal({"--breaks", wrong}),
              "--breaks wants rising numbers with commas between them, quantile or equal, not '" +
                  std::string(wrong) + "'");
  }
  for (const char* wrong : {"1", "1,2,3", "2,1", "a,b"}) {
    EXPECT_EQ(Colours().refusal({"--range", wrong}),
              "--range wants two rising numbers with a comma between them, not '" +
                  std::string(wrong) + "'");
  }
  EXPECT_EQ(Colours().refusal({"--palette", "jet"}),
            "--palette wants viridis, blues, browns or greys, not 'jet'");
}

TEST(ColourOptions, are_of_rainfall_and_lay_classes_in_one_way) {
  Colours palette;
  palette.read({"--palette", "blues"});
  EXPECT_EQ(palette.contradiction(true), "");
  EXPECT_EQ(palette.contradiction(false),
            "--palette is about the colours of rainfall, and there is no RAINFALL");
  for (const char* other : {"1,2", "quantile"}) {
    Colours both;
    both.read({"--range", "0,50", "--breaks", other});
    EXPECT_EQ(both.contradiction(true), "--range lays equal classes, and --breaks others");
  }
}

}  // namespace
}  // namespace thiessen::cli
