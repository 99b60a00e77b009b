#include "cli/options/blocks/dual_options.h"

#include <string>
#include <utility>
#include <vector>

#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct OfCells : Given<DualOptions> {
  explicit OfCells(std::vector<std::string> words) {
    block.declare(options);
    read(std::move(words));
  }
};

TEST(DualOptions, AskForNothingUnlessTold) {
  const OfCells none({});
  EXPECT_FALSE(none.block.any());
  EXPECT_FALSE(none.block.takes_place_of_cells());
}

TEST(DualOptions, NameFiles) {
  const OfCells both({"--delaunay", "t.geojson", "--neighbours", "n.csv"});
  EXPECT_TRUE(both.block.any());
  EXPECT_EQ(both.block.delaunay, "t.geojson");
  EXPECT_EQ(both.block.neighbours, "n.csv");
  EXPECT_FALSE(both.block.takes_place_of_cells());
  EXPECT_EQ(OfCells({"--delaunay=-"}).block.delaunay, "-");
  EXPECT_EQ(OfCells({"--delaunay", "-"}).block.delaunay, "-");
}

TEST(DualOptions, WithoutAFileTrianglesTakeThePlaceOfTheCells) {
  EXPECT_TRUE(OfCells({"--delaunay"}).block.takes_place_of_cells());
  EXPECT_TRUE(OfCells({"--delaunay", "--neighbours", "n.csv"}).block.takes_place_of_cells());
}

TEST(DualOptions, OnlyOneOutputGoesToTheStandardOutput) {
  const std::string two = "two outputs cannot both be the standard output";
  EXPECT_EQ(OfCells({"--delaunay", "-"}).contradiction(true), two);
  EXPECT_EQ(OfCells({"--delaunay", "-"}).contradiction(false), "");
  EXPECT_EQ(OfCells({"--delaunay", "-", "--neighbours", "-"}).contradiction(false), two);
  EXPECT_EQ(OfCells({"--delaunay", "--neighbours", "-"}).contradiction(true), two);
  EXPECT_EQ(OfCells({"--delaunay", "--neighbours", "n"}).contradiction(true), "");
}

}  // namespace
}  // namespace thiessen::cli
