#include "cli/catalogue/catalogue.h"

#include <algorithm>
#include <utility>

#include "cli/options/option_values.h"

namespace thiessen::cli {
namespace {

void declare_help(OptionGroup group, const std::string& help) {
  group.add("--version", sign(), "the version, the commit and the versions of libraries");
  group.add("-h,--help", sign(), help);
}

}  // namespace

Catalogue::Catalogue(std::string program) : program_(std::move(program)) {
  declare_help(options_.group("Options"), "this help; every command has its own");
}

void Catalogue::add(std::unique_ptr<Command> command) {
  declare_help(command->options().group(general_group), "this help");
  commands_.push_back(std::move(command));
}

Command* Catalogue::find(const std::string& name) const {
  const auto found = std::find_if(commands_.begin(), commands_.end(),
                                  [&](const auto& command) { return name == command->name(); });
  return found == commands_.end() ? nullptr : found->get();
}

std::vector<std::string> Catalogue::names() const {
  std::vector<std::string> names;
  names.reserve(commands_.size());
  for (const auto& command : commands_) names.emplace_back(command->name());
  return names;
}

}  // namespace thiessen::cli
