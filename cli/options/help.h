#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace thiessen::cli {

/// How the help looks: the files and the options that must be there in the usage line, options in
/// groups, no line longer than a terminal's 80 columns where a word allows it.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();
  std::string make_description(const CLI::App* app) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

/// `-o` where the option has such a name, else `--size`, else RAINFALL.
std::string short_name(const CLI::Option& option);

/// What stands for its value: FIELD, or `geodesic or planar` where it is one of a list.
std::string value_of(const CLI::Option& option);

}  // namespace thiessen::cli
