#include "cli/commands/commands.h"

#include <algorithm>
#include <utility>

#include "cli/options/option_values.h"

namespace thiessen::cli {
namespace {

void declare_help(OptionGroup group, const std::string& help) {
  group.add("--version", sign(), "the version");
  group.add("-h,--help", sign(), help);
}

}  // namespace

Commands::Commands(std::string program) : program_(std::move(program)) {
  commands_.push_back(make_run_command());
  commands_.push_back(make_cells_command());
  commands_.push_back(make_weights_command());
  commands_.push_back(make_rain_command());
  commands_.push_back(make_map_command());
  commands_.push_back(make_check_command());
  commands_.push_back(make_tessel_command());
  commands_.push_back(make_help_command(*this));
  declare_help(options_.group("Options"), "this help; every command has its own");
  for (const auto& command : commands_)
    declare_help(command->options().group(general_group), "this help");
}

Command* Commands::find(const std::string& name) const {
  const auto found = std::find_if(commands_.begin(), commands_.end(),
                                  [&](const auto& command) { return name == command->name(); });
  return found == commands_.end() ? nullptr : found->get();
}

std::vector<std::string> Commands::names() const {
  std::vector<std::string> names;
  names.reserve(commands_.size());
  for (const auto& command : commands_) names.emplace_back(command->name());
  return names;
}

}  // namespace thiessen::cli
