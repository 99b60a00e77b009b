#include <fcntl.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "base/temporary_folder.h"
#include "cli/session/interpreter.h"

namespace thiessen::cli {
namespace {

TEST(SessionHelp, law_1_names_every_command_once_and_the_session_knows_each) {
  const TemporaryFolder folder;
  OutputFile output("out", open_descriptor(folder.path("out"), O_WRONLY | O_CREAT, 0600),
                    OutputFile::Care::closed);
  Warnings warnings;
  const auto interpreter = make_interpreter(2, {output, warnings, false, false, {}});
  std::set<std::string> names;
  for (const std::string& name : session_commands()) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_NE(session_help().find("  " + name + " "), std::string::npos) << name;
    std::string said;
    try {
      interpreter->perform(name);
    } catch (const Error& error) {
      said = error.what();
    }
    EXPECT_EQ(said.find("there is no command"), std::string::npos) << said;
  }
  EXPECT_EQ(names.size(), 16U);
}

TEST(SessionHelp, law_2_every_line_ends_and_none_in_blanks) {
  std::istringstream lines(session_help());
  for (std::string line; std::getline(lines, line);) {
    EXPECT_FALSE(line.ends_with(' ')) << line;
  }
  EXPECT_TRUE(session_help().ends_with('\n'));
}

TEST(SessionHelp, tells_the_form_of_what_is_printed) {
  for (const char* form : {"point ID X Y [Z]", "forming F1 F2 F3 [F4] neighbors N1 N2 N3 [N4]",
                           "sound: N points, M vertices, dimension D"})
    EXPECT_NE(session_help().find(form), std::string::npos) << form;
}

}  // namespace
}  // namespace thiessen::cli
