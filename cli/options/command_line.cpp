#include "cli/options/command_line.h"

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "cli/commands/commands.h"
#include "cli/options/help.h"
#include "cli/options/usage.h"

namespace thiessen::cli {
namespace {

void require_file_names(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const bool is_input = option->get_positional();
    const bool is_file = is_input || option->check_name("--output");
    if (is_file && option->count() > 0 && option->results().front().empty()) {
      throw Error(
          {"", 0, (is_input ? "the name of " : "") + short_name(*option) + " is empty", ""});
    }
  }
}

}  // namespace

CommandLine::CommandLine(const std::string& program)
    : commands_(make_commands()),
      app_("Areal rainfall from rain gauges by exact Thiessen polygons.", "thiessen") {
  const std::string version = std::string("thiessen ") + THIESSEN_VERSION;
  const auto example = [&](const Command& command) {
    const std::string notes = command.notes();
    return notes + (notes.empty() ? "" : "\n") + "Example, in the folder of the clone:\n  " +
           printable(program) + " " + command.name() + " " + command.example();
  };
  app_.formatter(std::make_shared<HelpFormatter>());
  app_.set_version_flag("--version", version, "the version");
  app_.set_help_flag("-h,--help", "this help; every command has its own");
  app_.require_subcommand(1);
  app_.footer(example(*commands_.front()));
  for (const auto& command : commands_) add(*command, version, example(*command));
}

void CommandLine::add(Command& command, const std::string& version, const std::string& example) {
  CLI::App& app = *app_.add_subcommand(command.name(), command.description());
  app.group("Commands");
  command.set_up(app);
  app.set_version_flag("--version", version, "the version");
  app.set_help_flag("-h,--help", "this help");
  app.footer(example);
}

Command* CommandLine::parse(std::vector<std::string> arguments) {
  bring_command_forward(arguments);
  std::reverse(arguments.begin(), arguments.end());  // as the parser wants them
  try {
    app_.parse(arguments);
  } catch (const CLI::Success& success) {
    print(success);
    return nullptr;
  } catch (const CLI::ParseError& error) {
    throw usage_error(app_, error);
  }
  for (const auto& command : commands_) {
    if (!app_.got_subcommand(command->name())) continue;
    require_file_names(*app_.get_subcommand(command->name()));
    return command.get();
  }
  return nullptr;
}

// Options may stand anywhere, before the command too.
void CommandLine::bring_command_forward(std::vector<std::string>& arguments) const {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--") return;
    if (argument.size() > 1 && argument[0] == '-') {
      if (takes_value(argument)) ++i;
      continue;
    }
    if (is_command(argument)) {
      std::rotate(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(i),
                  arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
    return;
  }
}

bool CommandLine::is_command(const std::string& text) const {
  return std::any_of(commands_.begin(), commands_.end(),
                     [&](const auto& command) { return text == command->name(); });
}

bool CommandLine::takes_value(const std::string& option) const {
  for (const CLI::App* app : app_.get_subcommands({})) {
    const CLI::Option* found = app->get_option_no_throw(option);
    if (found != nullptr) return found->get_expected_min() > 0 && found->get_type_size() > 0;
  }
  return false;
}

void CommandLine::print(const CLI::Success& success) const {
  std::ostringstream text;
  app_.exit(success, text, text);
  OutputFile file = standard_output();
  file.append(text.str());
  file.finish();
}

}  // namespace thiessen::cli
