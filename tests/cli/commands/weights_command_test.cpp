#include "cli/command_lines.h"

namespace thiessen::cli {
namespace {

TEST(WeightsCommand, TakesReadingsByAnOption) {
  EXPECT_EQ(group_of("weights", "RAINFALL"), "");
  EXPECT_EQ(group_of("weights", "--influence"), "What if");
  EXPECT_EQ(group_of("weights", "--missing"), "Readings");
  EXPECT_EQ(group_of("weights", "--cache"), "Method");
}

/// A value that the option takes.
std::string value_of(const std::string& option) {
  if (option.ends_with("separator")) return ";";
  if (option.ends_with("encoding")) return "Latin-1";
  if (option == "--observed-at") return "09:00";
  return option.ends_with("format") ? "%Y" : "2013";
}

/// Whether an option says more of --totals.
bool is_about_totals(const std::string& option) {
  return option.starts_with("--totals-") || option.starts_with("--observed-") ||
         option == "--stamp";
}

TEST(WeightsCommand, RefusesWhatIsAboutReadingsWithoutThem) {
  const Commands commands("thiessen");
  std::size_t refused = 0;
  for (const Option& option : commands.find("weights")->options().options()) {
    const bool is_about_readings = option.group == "Readings" || option.name == "--cache";
    if (!is_about_readings) continue;
    ++refused;
    std::vector<std::string> line{"weights", "s", "b", option.name};
    const bool is_chosen = !option.value.choices.empty();
    if (!option.is_flag())
      line.push_back(is_chosen ? option.value.choices.front() : value_of(option.name));
    EXPECT_EQ(refusal(line), option.name + " is about readings, and there is no --influence");
    line.insert(line.end(), {"--influence", "r"});
    if (is_about_totals(option.name)) {
      const std::string about =
          option.name == "--stamp" ? "normals of months and totals" : "totals";
      EXPECT_EQ(refusal(line),
                option.name + " is about " + about + " beside RAINFALL, and there are none");
      line.insert(line.end(), {"--totals", "t"});
      if (option.name == "--observed-day") line.insert(line.end(), {"--observed-at", "09:00"});
    }
    EXPECT_EQ(refusal(line), "");
  }
  EXPECT_EQ(refused, 29u);
}

TEST(WeightsCommand, LooksAtInfluenceOrAtChanges) {
  const std::string text =
      "--influence looks at the network as it is, --with and --without change it";
  EXPECT_EQ(refusal({"weights", "s", "b", "--influence", "r", "--with", "1,2"}), text);
  EXPECT_EQ(refusal({"weights", "s", "b", "--influence", "r", "--without", "A"}), text);
  EXPECT_EQ(refusal({"weights", "s", "b", "--without", "A", "--with", "1,2"}), "");
}

TEST(WeightsCommand, MayRepeatChanges) {
  const ReadLine line({"weights", "s", "b", "--without", "A", "--without", "B"});
  EXPECT_EQ(line.option("--without").texts, (std::vector<std::string>{"A", "B"}));
}

TEST(WeightsCommand, WritesWhatModelsRead) {
  EXPECT_EQ(group_of("weights", "--format"), "Output");
  EXPECT_EQ(refusal({"weights", "s", "b", "--format", "hms"}), "");
  EXPECT_EQ(refusal({"weights", "s", "b", "--format", "hms", "--without", "A"}),
            "--with and --without compare two networks, and --format hms holds one");
}

}  // namespace
}  // namespace thiessen::cli
