#include "cli/session/command_arguments.h"

#include <gtest/gtest.h>

#include <cmath>

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
  EXPECT_FALSE(read_show_arguments({"a.png"}).view);
  EXPECT_TRUE(read_show_arguments({"--view", "1,2,3", "a.PNG", "--site", "0,0,0"}).view);
  EXPECT_THROW(read_show_arguments({"a.jpg"}), Error);
  EXPECT_THROW(read_show_arguments({"a.png", "--view", "1,2,3"}), Error);
  EXPECT_THROW(read_show_arguments({"a.png", "--site", "1,2,3"}), Error);
  EXPECT_THROW(read_show_arguments({"a.png", "--view", "1,2"}), Error);
}

}  // namespace
}  // namespace thiessen::cli
