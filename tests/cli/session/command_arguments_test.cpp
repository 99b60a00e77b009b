#include "cli/session/command_arguments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/error.h"

namespace thiessen::cli {
namespace {

TEST(CommandArguments, AreAsManyCoordinatesAsDimensions) {
  EXPECT_EQ(read_coordinates<2>("add", {"1", "-2.5"})[1], -2.5);
  EXPECT_EQ(read_coordinates<3>("add", {"1", "2", "3"})[2], 3);
  EXPECT_THROW(read_coordinates<2>("add", {"1", "2", "3"}), Error);
  EXPECT_THROW(read_coordinates<3>("add", {"1", "2"}), Error);
  EXPECT_THROW(read_coordinates<2>("add", {"1,2"}), Error);
}

TEST(CommandArguments, ZeroHasOneSign) {
  EXPECT_FALSE(std::signbit(read_coordinates<2>("add", {"-0", "0"})[0]));
}

TEST(CommandArguments, NameOneFile) {
  EXPECT_EQ(require_file("load", {"a b"}), "a b");
  EXPECT_THROW(require_file("load", {}), Error);
  EXPECT_THROW(require_file("load", {""}), Error);
  EXPECT_THROW(require_file("load", {"a", "b"}), Error);
  EXPECT_THROW(require_none("undo", {"2"}), Error);
}

TEST(CommandArguments, ShowAFileFromAViewToASite) {
  EXPECT_FALSE(read_show_arguments("show", 3, {"a.png"}).view);
  const auto seen =
      read_show_arguments("show", 3, {"--view", "1,2,3", "a.PNG", "--site", "0,0,-5e1"});
  ASSERT_TRUE(seen.view);
  EXPECT_EQ(seen.view->view, (SpacePoint{1, 2, 3}));
  EXPECT_EQ(seen.view->site, (SpacePoint{0, 0, -50}));
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"a.jpg"},
           {"a.png", "--view", "1,2,3"},
           {"a.png", "--site", "1,2,3"},
           {"a.png", "--view", "1,2"},
           {"a.png", "--view", "1,2,3,4", "--site", "0,0,0"},
           {"a.png", "--view"},
           {"a.png", "--view", "1,2,3", "--view", "1,2,3", "--site", "0,0,0"},
           {"a.png", "--zoom", "2"}})
    EXPECT_THROW(read_show_arguments("show", 3, words), Error) << words.back();
  EXPECT_EQ(complaint_of([] {
              read_show_arguments("show", 3, {"a.png", "--window", "0,0,1,1"});
            }),
            "--window is for two dimensions | --view and --site say what is seen in space");
  EXPECT_EQ(complaint_of([] {
              read_show_arguments("watch", 2, {"a.png", "--view", "0,0,1", "--site", "1,1,1"});
            }),
            "--view and --site are for three dimensions | --window says which part of the plane is "
            "shown");
}

TEST(CommandArguments, ShowAWindowOfThePlane) {
  const auto shown = read_show_arguments("show", 2, {"a.png", "--window", "-1,2,1e3,2.5"});
  ASSERT_TRUE(shown.window);
  EXPECT_EQ(shown.window->low, (Point{-1, 2}));
  EXPECT_EQ(shown.window->high, (Point{1000, 2.5}));
  const auto complaint = [](const std::string& window) {
    return complaint_of([&] { read_show_arguments("show", 2, {"a.png", "--window", window}); });
  };
  const std::string count = "--window takes four numbers, XMIN,YMIN,XMAX,YMAX, not ";
  EXPECT_EQ(complaint("0,0,1"), count + "'0,0,1'");
  EXPECT_EQ(complaint("0,0,1,1,2"), count + "'0,0,1,1,2'");
  EXPECT_TRUE(complaint("0,0,one,1").starts_with("--window: XMAX is no number: 'one'"));
  EXPECT_TRUE(complaint("0,,1,1").starts_with("--window: YMIN is no number: ''"));
  EXPECT_TRUE(complaint("0,0,inf,1").starts_with("--window: XMAX is "));
  EXPECT_TRUE(complaint("nan,0,1,1").starts_with("--window: XMIN is "));
  EXPECT_TRUE(complaint("0,0,1e300,1").starts_with("--window: XMAX is outside "));
  EXPECT_TRUE(complaint("0,0,0,1").starts_with(
      "--window is empty: XMIN, 0, is not below XMAX, 0 | first the lower left corner"));
  EXPECT_TRUE(complaint("0,3,1,2").starts_with("--window is empty: YMIN, 3, is not below YMAX, 2"));
  EXPECT_EQ(complaint("1000000,0,1000000.0000000002,1"),
            "--window is too narrow to tell coordinates in it apart, from XMIN to XMAX");
}

TEST(CommandArguments, ShowTakesAValueBehindAnEqualsSignToo) {
  const auto shown =
      read_show_arguments("show", 2, {"--window=-1,2,1e3,2.5", "a=b.png", "--size=800x600"});
  ASSERT_TRUE(shown.window);
  EXPECT_EQ(shown.window->low, (Point{-1, 2}));
  EXPECT_EQ(shown.file, "a=b.png");
  EXPECT_EQ(shown.size.height, 600);
  EXPECT_EQ(complaint_of([] {
              read_show_arguments("show", 2, {"a.png", "--dpi=1", "--dpi", "2"});
            }),
            "--dpi is given twice");
  EXPECT_TRUE(complaint_of([] {
                read_show_arguments("show", 2, {"a.png", "--windows=1"});
              }).starts_with("there is no option '--windows'"));
}

// 297 mm at 300 dots to the inch: 297 / 25.4 * 300 = 3507.9 pixels.
TEST(CommandArguments, ShowAPictureOfASizeAsMapDoes) {
  const auto size = [](const std::vector<std::string>& words) {
    return read_show_arguments("show", 2, words).size;
  };
  EXPECT_EQ(size({"a.png"}).width, 1600);
  EXPECT_EQ(size({"a.png"}).height, 0);
  EXPECT_EQ(size({"a.png", "--size", "800"}).width, 800);
  EXPECT_EQ(size({"a.png", "--size", "800x600"}).height, 600);
  EXPECT_EQ(size({"a.png", "--size", "297x210mm"}).width, 3508);
  EXPECT_EQ(size({"a.png", "--size", "297x210mm"}).dots_to_the_inch, 300);
  EXPECT_EQ(size({"a.png", "--size", "254x127mm", "--dpi", "100"}).height, 500);
  EXPECT_EQ(size({"a.png", "--dpi", "96"}).dots_to_the_inch, 96);
  for (const char* wrong : {"0", "5x5", "800x", "1e3", "99999x99999", "1x1mm"})
    EXPECT_THROW(size({"a.png", "--size", wrong}), Error) << wrong;
  EXPECT_THROW(size({"a.png", "--dpi", "0"}), Error);
}

}  // namespace
}  // namespace thiessen::cli
