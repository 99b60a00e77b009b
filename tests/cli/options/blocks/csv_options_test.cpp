#include "cli/options/blocks/csv_options.h"

#include <string>
#include <vector>

#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

using Texts = std::vector<std::string>;

TEST(CsvOptions, columns_are_numbers_where_all_that_are_named_are) {
  EXPECT_EQ(numbers_in({"1", "", "12"}), (Texts{"1", "12"}));
  EXPECT_EQ(numbers_in({"1", "id", "12"}), Texts{}) << "one name, and there is a header";
  EXPECT_EQ(numbers_in({"1.5"}), Texts{});
  EXPECT_EQ(numbers_in({"-1"}), Texts{});
  EXPECT_EQ(numbers_in({"", ""}), Texts{});
  EXPECT_EQ(numbers_in({}), Texts{});
}

struct AllFiles : Given<CsvOptionsOf> {
  AllFiles() {
    OptionGroup group = options.group("Files");
    block.declare(group);
  }
};

struct OneFile : Given<CsvOptionsOf> {
  OneFile() {
    OptionGroup group = options.group("Files");
    of_it = block.declare_for(group, "STATIONS");
  }
  std::vector<const Option*> of_it;
};

TEST(CsvOptions, say_nothing_unless_they_are_given) {
  AllFiles files;
  files.read({});
  EXPECT_EQ(files.block.said().separator, '\0');
  EXPECT_FALSE(files.block.said().decimal_comma);
  EXPECT_EQ(files.block.said().encoding, "");
  EXPECT_FALSE(files.block.said().skip);
}

TEST(CsvOptions, say_how_files_are_written) {
  AllFiles files;
  files.read({"--separator", "tab", "--decimal-comma", "--encoding", "cp932", "--skip", "3"});
  EXPECT_EQ(files.block.said().separator, '\t');
  EXPECT_TRUE(files.block.said().decimal_comma);
  EXPECT_EQ(files.block.said().encoding, "cp932");
  EXPECT_EQ(files.block.said().skip, 3U);
  EXPECT_NE(AllFiles().refusal({"--separator", ";;"}), "");
  EXPECT_NE(AllFiles().refusal({"--encoding", "no such encoding"}), "");
  EXPECT_NE(AllFiles().refusal({"--skip", "-1"}), "");
}

TEST(CsvOptions, of_one_file_bear_its_name) {
  OneFile stations;
  ASSERT_EQ(stations.of_it.size(), 4U);
  for (const Option* option : stations.of_it)
    EXPECT_TRUE(option->name.starts_with("--stations-")) << option->name;
  stations.read({"--stations-skip", "0", "--stations-separator", ";"});
  EXPECT_EQ(stations.block.said().skip, 0U) << "nothing stands before the header";
  EXPECT_EQ(stations.block.said().separator, ';');
  EXPECT_EQ(OneFile().refusal({"--separator", ";"}), "unknown option '--separator'");
}

TEST(CsvOptions, law_1_what_is_said_of_one_file_goes_before_what_is_said_of_all) {
  CsvDialect all;
  all.separator = ';';
  all.encoding = "Latin-1";
  all.skip = 3;
  all.numbers = {"1", "2"};
  OneFile nothing;
  nothing.read({});
  const CsvDialect same = nothing.block.or_else(all);
  EXPECT_EQ(same.separator, ';');
  EXPECT_EQ(same.encoding, "Latin-1");
  EXPECT_EQ(same.skip, 3U);
  EXPECT_TRUE(same.skip_is_of_all);
  EXPECT_EQ(same.numbers, all.numbers);
  EXPECT_FALSE(same.decimal_comma);
  OneFile other;
  other.read({"--stations-separator", "tab", "--stations-encoding", "cp932", "--stations-skip", "0",
              "--stations-decimal-comma"});
  const CsvDialect own = other.block.or_else(all);
  EXPECT_EQ(own.separator, '\t');
  EXPECT_EQ(own.encoding, "cp932");
  EXPECT_EQ(own.skip, 0U);
  EXPECT_FALSE(own.skip_is_of_all);
  EXPECT_TRUE(own.decimal_comma);
  all.decimal_comma = true;
  EXPECT_TRUE(nothing.block.or_else(all).decimal_comma);
}

}  // namespace
}  // namespace thiessen::cli
