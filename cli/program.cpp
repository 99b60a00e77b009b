#include "cli/program.h"

#include <algorithm>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "io/drivers.h"

namespace thiessen::cli {
namespace {

enum Status { done = 0, failed = 1, wrong_usage = 2 };

void print(const char* kind, const std::string& text, const std::string& hint) {
  std::cerr << "thiessen: " << kind << ": " << text << '\n';
  if (!hint.empty()) std::cerr << "hint: " << printable(hint) << '\n';
}

void print(const Error& error) {
  for (const Message& message : error.messages()) print("error", message.sentence(), message.hint);
  if (error.unlisted() > 0) print("error", "and " + std::to_string(error.unlisted()) + " more", "");
}

void print(const Warnings& warnings) {
  for (const Message& message : warnings.messages())
    print("warning", message.sentence(), message.hint);
}

/// The parsed command line, and the sentences for what is wrong with it.
class CommandLine {
 public:
  CommandLine() : app_("Areal rainfall from rain gauges by exact Thiessen polygons.", "thiessen") {
    app_.set_version_flag("--version", std::string("thiessen ") + THIESSEN_VERSION, "the version");
    app_.set_help_flag("-h,--help", "this help; every command has its own");
    app_.require_subcommand(1);
    for (auto& command : commands_) {
      CLI::App* sub = app_.add_subcommand(command->name(), command->description());
      sub->set_help_flag("-h,--help", "this help");
      command->set_up(*sub);
      sub->footer(std::string("Example, in the folder of the clone:\n  ") + command->example());
      sub->get_formatter()->column_width(28);
    }
    app_.footer("Example: thiessen run stations.csv basins.geojson rainfall.csv -o results");
  }

  /// The command to run; none where the help or the version was all that was asked for.
  Command* parse(std::vector<std::string> arguments) {
    bring_command_forward(arguments);
    std::reverse(arguments.begin(), arguments.end());  // as the parser wants them
    try {
      app_.parse(arguments);
    } catch (const CLI::Success& help) {
      standard_output_text(help);
      return nullptr;
    } catch (const CLI::ParseError& error) {
      throw UsageError{sentence(error), hint()};
    }
    for (auto& command : commands_) {
      if (app_.got_subcommand(command->name())) return command.get();
    }
    return nullptr;
  }

 private:
  // Options may stand anywhere, before the command too.
  void bring_command_forward(std::vector<std::string>& arguments) const {
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
  bool is_command(const std::string& text) const {
    return std::any_of(commands_.begin(), commands_.end(),
                       [&](const auto& c) { return text == c->name(); });
  }
  bool takes_value(const std::string& option) const {
    for (const CLI::App* sub : app_.get_subcommands({})) {
      const CLI::Option* found = sub->get_option_no_throw(option);
      if (found != nullptr) return found->get_expected_min() > 0 && found->get_type_size() > 0;
    }
    return false;
  }

  void standard_output_text(const CLI::Success& success) const {
    std::ostringstream text;
    app_.exit(success, text, text);
    OutputFile file = standard_output();
    file.append(text.str());
    file.finish();
  }

  std::string sentence(const CLI::ParseError& error) const {
    const std::vector<std::string> extra = extras();
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !extra.empty()) {
      const std::string& first = extra.front();
      const bool is_option = first.size() > 1 && first[0] == '-';
      if (!is_option && app_.get_subcommands().empty())
        return "there is no command '" + printable(first) + "'";
      return (is_option ? "unknown option '" : "one file too many: '") + printable(first) + "'";
    }
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr &&
        app_.get_subcommands().empty()) {
      return extra.empty() ? "no command is given"
                           : "there is no command '" + printable(extra.front()) + "'";
    }
    std::string text = error.what();
    const std::string colon = ": ";
    const std::size_t at = text.find(colon);
    if (at != std::string::npos && text[0] == '-') text.replace(at, colon.size(), " ");
    return printable(text);
  }
  std::vector<std::string> extras() const {
    std::vector<std::string> all = app_.remaining();
    for (const CLI::App* sub : app_.get_subcommands()) {
      for (const std::string& text : sub->remaining()) all.push_back(text);
    }
    return all;
  }
  std::string hint() const {
    const auto used = app_.get_subcommands();
    if (!used.empty())
      return "thiessen " + used.front()->get_name() +
             " --help shows the files, the options and an example";
    return "the commands are run, cells, weights, rain, map and check; thiessen --help says what "
           "they do";
  }

  std::vector<std::unique_ptr<Command>> commands_ = make_commands();
  CLI::App app_;
};

int run_command(Command& command) {
  Warnings warnings;
  const auto report = [&] {
    if (!command.quiet()) print(warnings);
  };
  try {
    start_gdal();
    command.run(warnings);
  } catch (...) {
    report();
    throw;
  }
  report();
  return done;
}

}  // namespace

int run_program(int argc, char** argv) {
  try {
    hold_standard_streams();
    watch_for_interrupts();
    CommandLine command_line;
    Command* command = command_line.parse({argv + 1, argv + argc});
    return command == nullptr ? done : run_command(*command);
  } catch (const UsageError& error) {
    print("error", error.text, error.hint);
    return wrong_usage;
  } catch (const Error& error) {
    print(error);
    return failed;
  } catch (const Interrupted& interrupted) {
    print("error", "interrupted; nothing was written", "");
    return interrupted.exit_status();
  } catch (const std::bad_alloc&) {
    print("error", "not enough memory", "");
    return failed;
  } catch (const std::exception& error) {
    print("error", std::string("a fault of the program itself: ") + error.what(),
          "please report it with the input");
    return failed;
  }
}

}  // namespace thiessen::cli
