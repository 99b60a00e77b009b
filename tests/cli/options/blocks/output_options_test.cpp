#include "cli/options/blocks/output_options.h"

#include "base/error.h"
#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct Output : Given<OutputOptions> {
  explicit Output(Need need = Need::optional) { block.declare(options, need, "map.png", "help"); }
};

TEST(OutputOptions, are_the_standard_output_unless_told) {
  Output output;
  output.read({});
  EXPECT_EQ(output.block.output, "-");
  EXPECT_FALSE(output.block.rules({}).overwrite);
}

TEST(OutputOptions, name_a_file_that_may_be_replaced_where_told) {
  Output output;
  output.read({"-o", "a.png", "--overwrite"});
  EXPECT_EQ(output.block.output, "a.png");
  const OutputRules rules = output.block.rules({"stations.csv", ""});
  EXPECT_TRUE(rules.overwrite);
  EXPECT_EQ(rules.inputs, (std::vector<std::string>{"stations.csv", ""}));
}

TEST(OutputOptions, may_be_required) {
  EXPECT_EQ(Output(Need::required).refusal({}), "-o map.png is missing");
  EXPECT_EQ(Output(Need::required).refusal({"--output=x"}), "");
}

TEST(OutputOptions, of_a_folder_are_required_and_completed_by_folders) {
  Given<OutputOptions> folder;
  folder.block.declare_folder(folder.options, "help");
  EXPECT_EQ(folder.refusal({}), "-o DIR is missing");
  EXPECT_EQ(folder.options.find("-o")->value.completion, Completion::folder);
  EXPECT_EQ(Output().options.find("-o")->value.completion, Completion::file);
}

TEST(OutputOptions, a_table_has_no_name_of_another_format) {
  for (const char* name : {"w.csv", "W.TXT", "weights", "a.b/weights", ".hidden", "w."})
    EXPECT_NO_THROW(require_table_name(name)) << name;
  for (const char* name : {"w.xlsx", "w.geojson", "w.csv.gz"})
    EXPECT_THROW(require_table_name(name), Error) << name;
}

}  // namespace
}  // namespace thiessen::cli
