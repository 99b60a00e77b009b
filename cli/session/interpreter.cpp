#include "cli/session/interpreter.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "base/interrupt.h"
#include "base/outputs.h"
#include "base/utf8.h"
#include "cli/options/name_lists.h"
#include "cli/session/command_arguments.h"
#include "cli/session/loaded_file.h"
#include "cli/session/script_lines.h"
#include "cli/session/words.h"
#include "results/cell_measures_file.h"
#include "results/mesh_file.h"
#include "tessellation/audit.h"
#include "tessellation/session.h"
#include "tessellation/topology_table.h"
#include "tessellation/topology_table_reader.h"
#include "text/last_line.h"
#include "text/points_file.h"
#include "text/similar_texts.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t findings_listed = 20;
constexpr const char* change_is_taken_back =
    "the change is taken back; watch off ends the pictures";

/// The words of a command after its name.
using Arguments = std::vector<std::string>;

[[noreturn]] void refuse(std::string text, std::string hint = {}) {
  throw Error(Message{"", 0, std::move(text), std::move(hint)});
}

/// Which command may be meant by a name that none has, or all of them.
std::string hint_for(const std::string& name) {
  std::string meant = did_you_mean(nearest_names(name, session_commands()));
  if (!meant.empty()) return meant;

  std::string all;
  for (const std::string& command : session_commands()) all += (all.empty() ? "" : ", ") + command;
  return "the commands are " + all;
}

template <int Dimension>
class SessionInterpreter : public Interpreter {
 public:
  explicit SessionInterpreter(Surroundings surroundings) : surroundings_(std::move(surroundings)) {}

  bool perform(std::string_view line) override {
    throw_if_interrupted();
    Arguments words = words_of(line);
    if (words.empty()) return true;
    const std::string name = words.front();
    words.erase(words.begin());
    if (name == "quit") {
      require_none(name, words);
      return false;
    }
    const auto found = std::find_if(commands.begin(), commands.end(),
                                    [&](const auto& command) { return command.first == name; });
    if (found == commands.end()) refuse("there is no command " + quoted(name, 40), hint_for(name));
    (this->*found->second)(words);
    return true;
  }
  std::size_t faults() const override { return faults_; }

 private:
  using Position = PositionIn<Dimension>;
  using Added = typename TessellationSession<Dimension>::Added;
  using Action = void (SessionInterpreter::*)(const Arguments&);
  static const std::array<std::pair<std::string_view, Action>, 15> commands;

  const Tessellation<Dimension>& tessellation() const { return session_.tessellation(); }
  NumberOf number_of() const {
    return [this](PointId p) { return session_.number_of(p); };
  }
  static Position position(const char* command, const Arguments& arguments) {
    const auto at = read_coordinates<Dimension>(command, arguments);
    if constexpr (Dimension == 2) {
      return {at[0], at[1]};
    } else {
      return {at[0], at[1], at[2]};
    }
  }

  /// Prints a sentence that is of use only to a person at a terminal.
  void say(const std::string& sentence) {
    if (surroundings_.is_terminal) surroundings_.output.append(sentence + "\n");
  }
  void say_count() {
    const std::size_t count = tessellation().count();
    say(std::to_string(count) + (count == 1 ? " point" : " points"));
  }

  void add(const Arguments& arguments) {
    say("point " + std::to_string(session_.add(position("add", arguments))));
  }
  void remove(const Arguments& arguments) {
    const auto number = session_.remove(position("delete", arguments));
    say("point " + std::to_string(number) + " is deleted");
  }
  void undo(const Arguments& arguments) {
    require_none("undo", arguments);
    session_.undo();
    say_count();
  }
  void redo(const Arguments& arguments) {
    require_none("redo", arguments);
    session_.redo();
    say_count();
  }
  void nearest(const Arguments& arguments) {
    const PointId p = session_.nearest(position("nearest", arguments));
    surroundings_.output.append(point_line(tessellation(), number_of(), p));
  }
  void cell(const Arguments& arguments) {
    const PointId p = session_.point_at(position("cell", arguments));
    surroundings_.output.append(
        cell_text(tessellation(), number_of(), find_cell(tessellation(), p)));
  }

  void load(const Arguments& arguments) {
    const std::string file = require_file("load", arguments);
    if (file == "-" && surroundings_.is_standard_input)
      refuse("the commands come from the standard input, so points cannot");
    LoadedFile loaded(file);
    const bool is_table = loaded.is_table();
    const auto added =
        is_table ? restored(std::move(loaded).input()) : added_of_csv(std::move(loaded).input());
    warn_of_equal(file, added.repeated, "equal an earlier one in it",
                  "equals an earlier one in it");
    warn_of_equal(file, added.there_already, "were there before", "was there before");
    auto& inputs = surroundings_.inputs;
    // What was saved may be saved again: the session holds all that is in it.
    if (!is_table && std::find(inputs.begin(), inputs.end(), file) == inputs.end())
      inputs.push_back(file);
    if (added.points == 0) return say("no new points");
    say("points " + std::to_string(added.first) + " to " + std::to_string(added.last));
  }
  Added added_of_csv(InputFile file) {
    Warnings warnings;
    const Added added = session_.add_all(read_points<Dimension>(std::move(file), warnings));
    for (const Message& message : warnings.messages()) surroundings_.warnings.add(message);
    for (const Message& notice : warnings.notices()) surroundings_.warnings.add_notice(notice);
    return added;
  }
  /// Takes in what a session has printed.
  Added restored(InputFile file) {
    tell_of_last_line(file.name(), surroundings_.warnings);
    ScriptLines lines(std::move(file));
    TopologyTableReader<Dimension> reader(lines.file());
    while (const auto line = lines.next([] {})) {
      throw_if_interrupted();
      reader.take(*line, lines.line());
    }
    const auto restored = session_.restore(std::move(reader).table());
    if (!restored.keeps_numbers) {
      warn(lines.file(), "its points are numbered on from " + std::to_string(restored.first) +
                             ", for numbers of its own are taken");
    }
    if (!restored.keeps_vertices) {
      warn(lines.file(), tessellation().count() == restored.points
                             ? "its vertices are numbered anew, for their numbers are too large"
                             : "its vertices are passed over, for there were points before");
    }
    const Added& added = restored;
    return added;
  }
  void warn(const std::string& file, const std::string& text) {
    surroundings_.warnings.add({file, 0, text, {}});
  }
  void warn_of_equal(const std::string& file, std::size_t count, const char* several,
                     const char* one) {
    if (count == 0) return;
    const std::string text =
        count == 1 ? std::string("1 point ") + one + ", and is passed over"
                   : std::to_string(count) + " points " + several + ", and are passed over";
    warn(file == "-" ? "standard input" : file, text);
  }

  void save(const Arguments& arguments) {
    write_named("save", arguments, [this](OutputFile& file) { append_table(file); });
  }
  void cells(const Arguments& arguments) {
    write_named("cells", arguments, [this](OutputFile& file) {
      write_cell_measures<Dimension>(file, tessellation(), number_of());
    });
  }
  void export_mesh(const Arguments& arguments) {
    const MeshFormat format = mesh_format<Dimension>(require_file("export", arguments));
    write_named("export", arguments, [&](OutputFile& file) {
      write_mesh<Dimension>(file, format, tessellation(), number_of());
    });
    if (tessellation().topology().dimension() < Dimension)
      warn(arguments.front(), Dimension == 2
                                  ? "the points are on one line, or too few: no triangles"
                                  : "the points are in one plane, or too few: no tetrahedra");
  }
  /// Writes the file that a command names; the standard output is left to what is printed.
  void write_named(const char* command, const Arguments& arguments,
                   const std::function<void(OutputFile&)>& fill) {
    const std::string name = require_file(command, arguments);
    if (name == "-")
      refuse(std::string(command) + " writes a file, and not to the standard output",
             "print without a file writes there");
    write_file(name, fill);
    say(name + " is written");
  }

  void append_table(OutputFile& file) const {
    write_topology_table<Dimension>(tessellation(), number_of(),
                                    [&](std::string_view line) { file.append(line); });
  }
  void print(const Arguments& arguments) {
    const auto table_to = [this](OutputFile& file) { append_table(file); };
    if (!arguments.empty() && arguments != Arguments{"-"}) {
      write_file(require_file("print", arguments), table_to);
      return say(arguments.front() + " is written");
    }
    if (surroundings_.is_terminal) return table_to(surroundings_.output);
    // Who reads a file or a pipe sees the whole table or, after Ctrl-C, nothing of it.
    surroundings_.output.flush();
    OutputFile whole = surroundings_.output.held();
    table_to(whole);
    whole.finish();
  }

  void show(const Arguments& arguments) {
    const ShowArguments shown = read_show_arguments("show", Dimension, arguments);
    if (tessellation().empty()) refuse("there are no points to show");
    write_picture(shown);
    say(shown.file + " is written");
  }

  void watch(const Arguments& arguments) {
    if (arguments == Arguments{"off"}) {
      if (watched_.empty()) refuse("nothing is watched");
      session_.watch({});
      say(std::exchange(watched_, {}) + " is written no more");
      return;
    }
    const ShowArguments shown = read_show_arguments("watch", Dimension, arguments);
    write_picture(shown);
    session_.watch([this, shown] { write_picture_of_change(shown); });
    watched_ = shown.file;
    say(watched_ + " is written, and will be after each change");
  }
  void write_picture_of_change(const ShowArguments& shown) {
    try {
      write_picture(shown);
    } catch (const Error& error) {
      std::vector<Message> messages = error.messages();
      for (Message& message : messages) {
        if (!message.hint.empty()) message.hint += "; ";
        message.hint += change_is_taken_back;
      }
      throw Error(std::move(messages), error.unlisted());
    }
  }

  void write_picture(const ShowArguments& shown) {
    write_file(shown.file, [&](OutputFile& file) {
      const auto bytes = picture(shown);
      file.append({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    });
  }
  std::vector<unsigned char> picture(const ShowArguments& shown) const {
    if constexpr (Dimension == 2) {
      return surroundings_.pictures.of_plane(tessellation(), number_of(), shown.window, shown.size);
    } else {
      return surroundings_.pictures.of_space(tessellation(), number_of(), shown.view, shown.size);
    }
  }

  /// Writes a file that replaces the one of this name, either whole or not at all.
  void write_file(const std::string& name, const std::function<void(OutputFile&)>& fill) {
    surroundings_.output.flush();
    Outputs outputs({true, surroundings_.inputs});
    fill(outputs.add(name));
    outputs.commit();
  }

  void check(const Arguments& arguments) {
    require_none("check", arguments);
    const auto findings = audit(tessellation());
    faults_ += findings.size();
    for (std::size_t i = 0; i < std::min(findings.size(), findings_listed); ++i)
      surroundings_.output.append(finding_line(findings[i]));
    if (findings.size() > findings_listed) {
      surroundings_.output.append("not sound: and " +
                                  std::to_string(findings.size() - findings_listed) + " more\n");
    }
    if (findings.empty()) surroundings_.output.append(sound_line());
  }
  static std::string finding_line(const Finding<Dimension>& finding) {
    std::string line = "not sound: " + std::string(name_of(finding.fault));
    if (finding.vertex != no_vertex)
      line += " at vertex " + std::to_string(index(finding.vertex) + 1);
    return line + " near " + position_text(finding.position) + "\n";
  }
  std::string sound_line() const {
    const auto& topology = tessellation().topology();
    std::size_t vertices = 0;
    if (topology.dimension() == Dimension) {
      topology.for_each_vertex([&](VertexId v) { vertices += topology.is_infinite(v) ? 0u : 1u; });
    }
    return "sound: " + std::to_string(tessellation().count()) + " points, " +
           std::to_string(vertices) + " vertices, dimension " +
           std::to_string(topology.dimension()) + "\n";
  }

  void help(const Arguments& arguments) {
    require_none("help", arguments);
    if (surroundings_.is_terminal) surroundings_.output.append(session_help());
  }

  Surroundings surroundings_;
  TessellationSession<Dimension> session_;
  std::string watched_;  // the file that is written after each change; empty: none
  std::size_t faults_ = 0;
};

template <int Dimension>
const std::array<std::pair<std::string_view, typename SessionInterpreter<Dimension>::Action>, 15>
    SessionInterpreter<Dimension>::commands = {{
        {"add", &SessionInterpreter::add},
        {"delete", &SessionInterpreter::remove},
        {"undo", &SessionInterpreter::undo},
        {"redo", &SessionInterpreter::redo},
        {"nearest", &SessionInterpreter::nearest},
        {"cell", &SessionInterpreter::cell},
        {"load", &SessionInterpreter::load},
        {"save", &SessionInterpreter::save},
        {"print", &SessionInterpreter::print},
        {"cells", &SessionInterpreter::cells},
        {"export", &SessionInterpreter::export_mesh},
        {"show", &SessionInterpreter::show},
        {"watch", &SessionInterpreter::watch},
        {"check", &SessionInterpreter::check},
        {"help", &SessionInterpreter::help},
    }};

}  // namespace

std::unique_ptr<Interpreter> make_interpreter(std::size_t dimension, Surroundings surroundings) {
  if (dimension == 2) return std::make_unique<SessionInterpreter<2>>(std::move(surroundings));
  return std::make_unique<SessionInterpreter<3>>(std::move(surroundings));
}

}  // namespace thiessen::cli
