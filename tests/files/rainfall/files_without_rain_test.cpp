#include "files/rainfall/files_without_rain.h"

#include <gtest/gtest.h>

#include "base/complaints.h"
#include "files/rainfall/published_rainfall.h"

namespace thiessen {
namespace {

JoinedReadings::Opened without(Warnings& warnings, const std::string& file) {
  warnings.add_notice({file, 0, "its fields are parted by tabs", ""});
  throw NoRain({file, 0, "no rain", ""});
}

/// Opens files, of which those called `none...` have no rain, and returns the notices.
std::vector<std::string> notices_of(const std::vector<std::string>& files) {
  FilesWithoutRain all(files.size(), "data");
  std::vector<std::string> notices;
  for (const std::string& file : files) {
    Warnings of_file;
    const FilesWithoutRain::Open open = [&](Warnings& warnings) {
      return file.starts_with("none") ? without(warnings, file) : JoinedReadings::Opened();
    };
    all.open_next(open, file, of_file);
    for (const Message& notice : of_file.notices()) notices.push_back(notice.sentence());
  }
  return notices;
}

TEST(FilesWithoutRain, are_named_with_the_last_file) {
  EXPECT_EQ(notices_of({"a", "b"}), std::vector<std::string>{});
  EXPECT_EQ(notices_of({"none", "a"}),
            std::vector<std::string>{"data: a file without rain is passed over: none"});
  EXPECT_EQ(notices_of({"none1", "a", "none2", "none3", "none4", "none5", "none6"}),
            std::vector<std::string>{"data: files without rain are passed over: none1, none2, "
                                     "none3, none4, none5 and 1 more"});
}

TEST(FilesWithoutRain, that_are_all_are_an_error_with_each) {
  EXPECT_EQ(complaints_of([] {
              notices_of({"none2", "none1"});
            }),
            (std::vector<std::string>{"none2: no rain", "none1: no rain"}));
}

}  // namespace
}  // namespace thiessen
