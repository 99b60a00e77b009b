#include "cli/options/blocks/isohyet_options.h"

#include <optional>
#include <string>
#include <vector>

#include "cli/options/given_options.h"
#include "cli/options/named_enumerators.h"

namespace thiessen::cli {
namespace {

/// The options of a map.
struct OfMap : Given<IsohyetOptions> {
  OfMap() { block.declare_map(options); }
  /// What is said of these words, for a map that shows rainfall or none, in a picture or a raster.
  std::string said_of(const std::vector<std::string>& words, bool has_rainfall, bool is_picture) {
    read(words);
    try {
      block.check_map(has_rainfall, is_picture);
    } catch (const UsageError& error) {
      return error.text;
    }
    return {};
  }
};

/// The options of isohyets alone.
struct OfLines : Given<IsohyetOptions> {
  OfLines() { block.declare(options); }
};

TEST(IsohyetOptions, of_a_map_show_cells_without_lines_unless_told) {
  OfMap map;
  map.read({});
  EXPECT_FALSE(map.block.surface());
  EXPECT_FALSE(map.block.shows_any());
  EXPECT_EQ(map.block.drawn(), SurfaceMethod::natural) << "whose lines would be drawn";
  EXPECT_EQ(map.block.interval, 0);
}

TEST(IsohyetOptions, of_a_map_choose_its_surface_and_the_lines_over_it) {
  OfMap surface;
  surface.read({"--method", "linear"});
  EXPECT_EQ(surface.block.surface(), SurfaceMethod::linear);
  EXPECT_EQ(surface.block.drawn(), SurfaceMethod::linear);
  EXPECT_TRUE(surface.block.shows_any());
  OfMap lines;
  lines.read({"--isohyets", "--interval", "2.5"});
  EXPECT_FALSE(lines.block.surface()) << "over the cells";
  EXPECT_TRUE(lines.block.shows_any());
  EXPECT_EQ(lines.block.interval, 2.5);
  OfMap cells;
  cells.read({"--method", "thiessen"});
  EXPECT_FALSE(cells.block.shows_any());
  EXPECT_EQ(OfMap().refusal({"--method", "kriging"}),
            "--method wants thiessen, idw, natural or linear, not 'kriging'");
}

TEST(IsohyetOptions, offer_every_surface_that_there_is) {
  const OfMap map;
  std::vector<std::string> names = names_of_enumerators<SurfaceMethod>(name_of);
  names.insert(names.begin(), "thiessen");
  EXPECT_EQ(map.options.at("--method").value.choices, names);
}

TEST(IsohyetOptions, of_a_map_are_about_rainfall) {
  EXPECT_EQ(OfMap().said_of({"--method", "idw"}, false, true),
            "--method is about rainfall between gauges, and there is no RAINFALL");
  EXPECT_EQ(OfMap().said_of({"--isohyets"}, false, true),
            "--isohyets is about rainfall, and there is no RAINFALL");
  EXPECT_EQ(OfMap().said_of({"--method", "thiessen"}, false, true), "");
  EXPECT_EQ(OfMap().said_of({"--method", "idw", "--isohyets", "--interval", "1"}, true, true), "");
}

TEST(IsohyetOptions, of_a_map_draw_lines_on_pictures_alone) {
  EXPECT_EQ(OfMap().said_of({"--isohyets"}, true, false),
            "--isohyets is about pictures, and a raster is written");
  EXPECT_EQ(OfMap().said_of({"--interval", "5"}, true, false),
            "--interval is about pictures, and a raster is written");
  EXPECT_EQ(OfMap().said_of({"--method", "idw"}, true, false), "") << "a raster has a surface, too";
}

TEST(IsohyetOptions, of_a_map_have_an_interval_only_beside_lines) {
  EXPECT_EQ(OfMap().said_of({"--interval", "5"}, true, true),
            "--interval is the step between isohyets, and none are drawn");
}

TEST(IsohyetOptions, of_lines_are_those_of_natural_neighbours_unless_told) {
  OfLines lines;
  lines.read({});
  EXPECT_EQ(lines.block.drawn(), SurfaceMethod::natural);
  EXPECT_EQ(lines.contradiction(), "");
  OfLines idw;
  idw.read({"--method", "idw", "--interval", "10"});
  EXPECT_EQ(idw.block.drawn(), SurfaceMethod::idw);
  EXPECT_EQ(idw.block.interval, 10);
  EXPECT_EQ(idw.contradiction(), "");
}

TEST(IsohyetOptions, of_lines_refuse_cells_which_have_none) {
  OfLines cells;
  cells.read({"--method", "thiessen"});
  EXPECT_EQ(cells.contradiction(), "cells have no isohyets: rainfall jumps from one to the next");
}

TEST(IsohyetOptions, of_lines_take_their_levels_in_one_way) {
  OfLines levels;
  levels.read({"--breaks", "0.5,10,20"});
  EXPECT_EQ(levels.block.breaks, (std::vector<double>{0.5, 10, 20}));
  EXPECT_EQ(levels.contradiction(), "");
  OfLines both;
  both.read({"--breaks", "10", "--interval", "5"});
  EXPECT_EQ(both.contradiction(), "--interval and --breaks both say the levels");
}

TEST(IsohyetOptions, law_1_levels_are_rising_numbers) {
  for (const std::string wrong : {"", ",", "1,", "2,1", "1,1", "a", "1;2", "nan", "quantile"}) {
    EXPECT_EQ(OfLines().refusal({"--breaks", wrong}),
              "--breaks is not a list of rising numbers such as 10,20,50, but '" + wrong + "'");
  }
  for (const std::string wrong : {"0", "-1", "x", "nan", "1e10"}) {
    EXPECT_EQ(OfLines().refusal({"--interval", wrong}),
              "--interval wants a number above 0, to 1e9, not '" + wrong + "'");
  }
}

}  // namespace
}  // namespace thiessen::cli
