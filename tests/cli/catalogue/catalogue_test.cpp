#include "cli/catalogue/catalogue.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace thiessen::cli {
namespace {

/// A command that does nothing.
class Named : public Command {
 public:
  explicit Named(std::string name) : name_(std::move(name)) {}
  const char* name() const override { return name_.c_str(); }
  const char* description() const override { return "nothing"; }
  const char* example() const override { return ""; }
  void run(Warnings&) override {}
  bool quiet() const override { return true; }

 private:
  std::string name_;
};

TEST(Catalogue, knows_its_commands_by_name_in_the_order_of_the_help) {
  Catalogue catalogue("here/thiessen");
  for (const char* name : {"run", "rain", "cells"}) catalogue.add(std::make_unique<Named>(name));
  EXPECT_EQ(catalogue.program(), "here/thiessen");
  EXPECT_EQ(catalogue.names(), (std::vector<std::string>{"run", "rain", "cells"}));
  ASSERT_EQ(catalogue.all().size(), 3U);
  EXPECT_EQ(catalogue.find("rain"), catalogue.all()[1].get());
  for (const char* other : {"", "r", "rain ", "Rain", "raining"})
    EXPECT_EQ(catalogue.find(other), nullptr) << other;
}

TEST(Catalogue, law_1_every_command_has_help_and_version_and_so_has_the_program_itself) {
  Catalogue catalogue("thiessen");
  catalogue.add(std::make_unique<Named>("run"));
  for (const OptionList* options :
       {&catalogue.options(), &std::as_const(*catalogue.find("run")).options()}) {
    ASSERT_NE(options->find("--help"), nullptr);
    EXPECT_EQ(options->find("-h"), options->find("--help"));
    ASSERT_NE(options->find("--version"), nullptr);
    EXPECT_TRUE(options->find("--help")->is_flag());
    EXPECT_TRUE(options->find("--version")->is_flag());
  }
  EXPECT_EQ(catalogue.find("run")->options().find("--help")->group, general_group);
}

}  // namespace
}  // namespace thiessen::cli
