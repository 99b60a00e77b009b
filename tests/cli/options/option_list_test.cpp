#include "cli/options/option_list.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "cli/options/option_values.h"

namespace thiessen::cli {
namespace {

class Colours : public OptionBlock {
 public:
  explicit Colours(OptionList& options) {
    options.group("Paint", *this).add("--red", flag(red), "with red");
    options.group("Output", *this).add("-b,--blue", text(blue, "SHADE"), "with a blue");
  }
  bool red = false;
  std::string blue;
};

TEST(OptionList, KeepsHeadingsInTheOrderInWhichTheyCome) {
  OptionList options;
  options.group("Files").add("SOURCE", {}, "a file");
  options.group("Output").add("--first", {}, "");
  options.group("Paint").add("--second", {}, "");
  options.group("Output").add("--third", {}, "");
  EXPECT_EQ(options.groups(), (std::vector<std::string>{"Files", "Output", "Paint"}));
}

TEST(OptionList, AnOptionStandsUnderTheHeadingOfItsDeclaration) {
  OptionList options;
  OptionGroup output = options.group("Output");
  options.group("Paint").add("--red", {}, "");
  output.add("--late", {}, "");
  EXPECT_EQ(options.find("--late")->group, "Output");
}

TEST(OptionList, FindsByNameAndByLetter) {
  OptionList options;
  const Colours colours(options);
  EXPECT_EQ(options.find("--blue"), options.find("-b"));
  EXPECT_EQ(options.find("-b")->short_name(), "-b");
  EXPECT_EQ(options.find("--red")->short_name(), "--red");
  EXPECT_EQ(options.find("-r"), nullptr);
  EXPECT_EQ(options.find(""), nullptr);
}

TEST(OptionList, HasAnOptionThatIsNotThereAsAFaultOfTheProgram) {
  OptionList options;
  const Colours colours(options);
  EXPECT_EQ(&options.at("--red"), options.find("--red"));
  EXPECT_THROW((void)options.at("--green"), std::logic_error);
}

TEST(OptionList, HasArgumentsInTheirOrder) {
  OptionList options;
  options.group("Files").add("SOURCE", {}, "");
  options.group("Paint").add("--red", {}, "");
  options.group("Files").add("TARGET", {}, "");
  ASSERT_EQ(options.arguments().size(), 2u);
  EXPECT_EQ(options.arguments()[1]->name, "TARGET");
}

TEST(OptionList, RefusesANameTwiceAsAFaultOfTheProgram) {
  OptionList options;
  const Colours colours(options);
  EXPECT_THROW(options.group("Else").add("--red", {}, ""), std::logic_error);
}

TEST(OptionBlock, KnowsWhichOfItsOptionsAreGiven) {
  OptionList options;
  options.group("Paint").add("--green", {}, "").texts = {"true"};
  const Colours colours(options);
  EXPECT_EQ(colours.first_given(), nullptr);
  options.find("--blue")->texts = {"navy"};
  EXPECT_EQ(colours.first_given()->name, "--blue");
  options.find("--red")->texts = {"true"};
  EXPECT_EQ(colours.first_given()->name, "--red");
}

TEST(OptionValue, IsToldInWords) {
  double width = 0;
  EXPECT_EQ(number(width, above_zero).in_words(), "NUMBER");
  EXPECT_EQ(choice<double>(width, {{"thin", 1}, {"wide", 2}, {"huge", 3}}).in_words(),
            "thin, wide or huge");
}

}  // namespace
}  // namespace thiessen::cli
