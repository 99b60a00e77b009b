#include "cli/options/option_values.h"

#include <gtest/gtest.h>

#include <array>

namespace thiessen::cli {
namespace {

/// What is said of the text; empty where it is taken.
std::string complaint(const OptionValue& value, const std::string& text) {
  try {
    value.read(text);
  } catch (const WrongValue& wrong) {
    return wrong.complaint;
  }
  return {};
}

TEST(OptionValues, NumbersLieInTheirRange) {
  double target = 7;
  const OptionValue value = number(target, {0, 10, "0 to 10"});
  EXPECT_EQ(complaint(value, "2.5"), "");
  EXPECT_EQ(target, 2.5);
  EXPECT_EQ(complaint(value, "10"), "");
  for (const char* wrong : {"10.001", "-1", "nan", "inf", "1,5", "", "1 ", "0x1"})
    EXPECT_EQ(complaint(value, wrong), "wants 0 to 10, not '" + std::string(wrong) + "'");
  EXPECT_EQ(target, 10);
}

TEST(OptionValues, WholeNumbersLieInTheirRange) {
  std::size_t target = 0;
  const OptionValue value = whole_number(target, 1, 16);
  EXPECT_EQ(complaint(value, "16"), "");
  EXPECT_EQ(target, 16u);
  for (const char* wrong : {"0", "17", "1.5", "1e1", "-1", "99999999999999999999"})
    EXPECT_EQ(complaint(value, wrong),
              "wants a whole number from 1 to 16, not '" + std::string(wrong) + "'");
}

TEST(OptionValues, SomeTextsMayBeEmpty) {
  std::string target = "before";
  EXPECT_EQ(complaint(text(target, "T"), ""), "is empty");
  EXPECT_EQ(target, "before");
  EXPECT_EQ(complaint(any_text(target, "T"), ""), "");
  EXPECT_EQ(target, "");
}

TEST(OptionValues, SomeMayBeRepeated) {
  std::vector<std::string> several;
  std::vector<Point> places;
  bool is_there = false;
  std::string once;
  EXPECT_TRUE(texts(several, "V").may_be_repeated);
  EXPECT_TRUE(points(places).may_be_repeated);
  EXPECT_TRUE(flag(is_there).may_be_repeated);
  EXPECT_FALSE(text(once, "V").may_be_repeated);
}

TEST(OptionValues, PointsAreTwoNumbersAndAComma) {
  std::vector<Point> target;
  EXPECT_EQ(complaint(points(target), "8.25,-47.5"), "");
  EXPECT_EQ(complaint(points(target), " 1 , 2 "), "");
  ASSERT_EQ(target.size(), 2u);
  EXPECT_EQ(target[0].y, -47.5);
  for (const char* wrong : {"8", "8,", ",8", "1,2,3", "a,b", ""})
    EXPECT_NE(complaint(points(target), wrong), "") << wrong;
  EXPECT_EQ(target.size(), 2u);
}

TEST(OptionValues, TimesAreIso8601AndExist) {
  std::optional<IsoTime> target;
  EXPECT_EQ(complaint(iso_time(target), "2013-08-31T06:00"), "");
  EXPECT_TRUE(target.has_value());
  EXPECT_EQ(complaint(iso_time(target), "2013-02-30"), "'2013-02-30' does not exist");
  EXPECT_EQ(complaint(iso_time(target), "31.08.2013").substr(0, 22), "wants an ISO 8601 time");
}

TEST(OptionValues, ASeparatorIsOneCharacterOrTab) {
  char target = '\0';
  EXPECT_EQ(complaint(separator(target), ";"), "");
  EXPECT_EQ(target, ';');
  for (const char* tab : {"tab", "\\t", "\t"}) {
    target = '\0';
    EXPECT_EQ(complaint(separator(target), tab), "");
    EXPECT_EQ(target, '\t');
  }
  for (const char* wrong : {"", ";;", "\"", "\n", "\r", "\xc2\xb7"})
    EXPECT_NE(complaint(separator(target), wrong), "");
}

TEST(OptionValues, APictureHasSidesAndAnArea) {
  PixelSize target;
  EXPECT_EQ(complaint(pixel_size(target), "800"), "");
  EXPECT_EQ(target.width, 800u);
  EXPECT_EQ(target.height, 0u);
  EXPECT_EQ(complaint(pixel_size(target), "800x600"), "");
  EXPECT_EQ(target.height, 600u);
  EXPECT_FALSE(target.millimetres);
  EXPECT_EQ(complaint(pixel_size(target), "297x210mm"), "");
  EXPECT_EQ(target.width, 297u);
  EXPECT_TRUE(target.millimetres);
  for (const char* wrong : {"", "x", "800x", "x600", "1x1", "800X600", "99999999x99999999", "mm",
                            "0mm", "297xmm", "9999mm", "297mmx210mm"})
    EXPECT_NE(complaint(pixel_size(target), wrong), "") << wrong;
}

TEST(OptionValues, AChoiceIsOneOfAList) {
  int target = 0;
  const OptionValue value = choice<int>(target, {{"one", 1}, {"two", 2}});
  EXPECT_EQ(value.kind, "one|two");
  EXPECT_EQ(complaint(value, "two"), "");
  EXPECT_EQ(target, 2);
  EXPECT_EQ(complaint(value, "three"), "wants one or two, not 'three'");
  EXPECT_EQ(complaint(value, "tw"), "wants one or two, not 'tw'");
}

}  // namespace
}  // namespace thiessen::cli
