#include <unistd.h>

#include <string>
#include <utility>
#include <vector>

#include "base/file.h"
#include "base/interrupt.h"
#include "base/utf8.h"
#include "cli/commands/commands.h"
#include "cli/options/option_values.h"
#include "cli/session/interpreter.h"
#include "cli/session/keyboard.h"
#include "cli/session/script_lines.h"
#include "cli/terminal/messages.h"
#include "gdal/output/image_file.h"
#include "map/plot/tessellation_picture.h"
#include "text/last_line.h"

namespace thiessen::cli {
namespace {

constexpr SessionPictures pictures{
    [](const Tessellation<2>& tessellation, const NumberOf& number_of,
       const std::optional<PlaneWindow>& window, const PlotSize& size) {
      return plane_picture(tessellation, number_of, image_file, window, size);
    },
    [](const Tessellation<3>& tessellation, const NumberOf& number_of,
       const std::optional<View>& view, const PlotSize& size) {
      return space_picture(tessellation, number_of, image_file, view, size);
    }};

/// The error of a line of a script: all of its messages, with the place of that line.
Error placed(const Error& error, const std::string& file, std::size_t line) {
  std::vector<Message> messages;
  for (const Message& message : error.messages())
    messages.push_back({file, line, message.placed(), message.hint});
  return {std::move(messages), error.unlisted()};
}

void run_script(ScriptLines& lines, Interpreter& interpreter, OutputFile& output) {
  const auto show_what_is_printed = [&] { output.flush(); };
  while (const auto line = lines.next(show_what_is_printed)) {
    try {
      if (!interpreter.perform(*line)) return;
    } catch (const Error& error) {
      throw placed(error, lines.file(), lines.line());
    }
  }
}

/// Carries out a typed line, and returns whether the session goes on. A command that fails is
/// reported and changes nothing, and so is one that Ctrl-C interrupts.
bool perform_typed(const std::string& line, Interpreter& interpreter, OutputFile& output) {
  try {
    if (const auto invalid = find_invalid_utf8(line))
      throw Error(Message{"", 0, "not UTF-8 at byte " + std::to_string(*invalid), {}});
    return interpreter.perform(line);
  } catch (const Error& error) {
    print("error: ", error);
  } catch (const Interrupted&) {
    if (!forget_ctrl_c()) throw;
    output.discard();
    print("", "interrupted: nothing is changed", "");
  }
  return true;
}

/// Shows what a command answered; after Ctrl-C the rest of it is dropped.
void show_answer(OutputFile& output) {
  try {
    output.flush();
  } catch (const Interrupted&) {
    if (!forget_ctrl_c()) throw;
    output.discard();
  }
}

class TesselCommand : public Command {
 public:
  TesselCommand() {
    options().group("Files").add(
        "SCRIPT", file(script_),
        "commands; without it, or with -, they come from the standard input, be it a pipe or a "
        "keyboard");
    OptionGroup general = options().group(general_group);
    OptionValue dimension = whole_number(dimension_, 2, 3);
    dimension.choices = {"2", "3"};
    general.add("--dim", std::move(dimension), "of the points: 2 (default) or 3");
    general.add("-q,--quiet", flag(quiet_), "no warnings");
  }

  const char* name() const override { return "tessel"; }
  const char* description() const override {
    return "a session: a tessellation in 2-D or 3-D, built, changed and shown by commands";
  }
  const char* example() const override { return "samples/thesis/figure11.txt"; }
  std::string notes() const override { return "Commands, one a line:\n" + session_help(); }
  const char* when_interrupted() const override { return "interrupted"; }

  void run(Warnings& warnings) override {
    OutputFile output = standard_output();
    const bool is_standard_input = script_ == "-";
    if (is_standard_input && isatty(STDIN_FILENO) == 1) {
      run_keyboard(output);
    } else {
      tell_of_last_line(script_, warnings);
      ScriptLines lines(script_);
      const auto interpreter = make_interpreter(
          dimension_, {output, warnings, false, is_standard_input, {script_}, pictures});
      try {
        run_script(lines, *interpreter, output);
      } catch (const Error&) {
        output.finish();
        throw;
      }
      faults_ = interpreter->faults();
    }
    output.finish();
    if (faults_ > 0)
      throw Error(Message{"", 0, "the tessellation is not sound: check tells where", {}});
  }
  bool quiet() const override { return quiet_; }

 private:
  void run_keyboard(OutputFile& output) {
    Warnings warnings;
    const bool is_terminal = isatty(STDOUT_FILENO) == 1;
    const auto interpreter =
        make_interpreter(dimension_, {output, warnings, is_terminal, true, {}, pictures});
    Keyboard keyboard(session_commands());
    if (is_terminal) {
      output.append("A tessellation in " + std::to_string(dimension_) +
                    "-D. help lists the commands; quit or Ctrl-D ends.\n");
      output.flush();
    }
    while (const auto line = keyboard.next()) {
      const bool goes_on = perform_typed(*line, *interpreter, output);
      show_answer(output);
      if (!quiet_) {
        for (const Message& message : warnings.messages()) print("warning: ", message);
      }
      warnings = {};
      if (!goes_on) break;
    }
    faults_ = interpreter->faults();
  }

  std::string script_ = "-";
  std::size_t dimension_ = 2;
  bool quiet_ = false;
  std::size_t faults_ = 0;
};

}  // namespace

std::unique_ptr<Command> make_tessel_command() {
  return std::make_unique<TesselCommand>();
}

}  // namespace thiessen::cli
