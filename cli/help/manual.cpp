#include "cli/help/manual.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <vector>

#include "cli/help/help.h"
#include "cli/help/manual_files.h"
#include "cli/help/roff.h"
#include "cli/options/name_lists.h"

namespace thiessen::cli {
namespace {

/// An option, and the commands in which it means the same.
struct SharedOption {
  const Option* option;
  std::vector<std::string> commands;
};

bool mean_the_same(const Option& a, const Option& b) {
  return a.name == b.name && a.help == b.help && a.value.kind == b.value.kind;
}

std::vector<SharedOption> shared_options(const Catalogue& commands) {
  std::vector<SharedOption> shared;
  for (const auto& command : commands.all()) {
    for (const Option& option : command->options().options()) {
      auto found = std::find_if(shared.begin(), shared.end(), [&](const SharedOption& other) {
        return mean_the_same(option, *other.option);
      });
      if (found == shared.end()) found = shared.insert(shared.end(), {&option, {}});
      found->commands.emplace_back(command->name());
    }
  }
  return shared;
}

/// The headings in the order in which they first occur, but with the general one last.
std::vector<std::string> headings(const std::vector<SharedOption>& options) {
  std::vector<std::string> names;
  for (const SharedOption& shared : options) {
    if (std::find(names.begin(), names.end(), shared.option->group) == names.end())
      names.push_back(shared.option->group);
  }
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return name != general_group; });
  return names;
}

/// An option and its value, `-o, --output FILE`, in the fonts of a manual.
std::string term(const Option& option) {
  if (option.is_argument()) return roff_italic(option.name);
  std::string text = option.letter == '\0' ? "" : roff_bold(option.short_name()) + ", ";
  text += roff_bold(option.name);
  return option.value.kind.empty() ? text : text + " " + roff_italic(option.value.kind);
}

std::string entry(const SharedOption& shared, std::size_t command_count) {
  const bool is_everywhere = shared.commands.size() == command_count;
  const std::string where = is_everywhere ? "" : " (" + and_list(shared.commands) + ")";
  return ".TP\n" + term(*shared.option) + "\n" +
         roff_paragraph(as_sentence(shared.option->help) + where);
}

std::string title() {
  return ".TH THIESSEN 1 " THIESSEN_DATE " \"thiessen " THIESSEN_VERSION "\" \"User Commands\"\n";
}

std::string beginning() {
  return ".SH NAME\nthiessen \\- areal rainfall from rain gauges by exact Thiessen polygons\n"
         ".SH SYNOPSIS\n.B thiessen\n.I COMMAND FILES\n.RI [ options ]\n"
         ".SH DESCRIPTION\n" +
         roff_paragraph(
             "Each rain gauge stands for the ground that is nearer to it than to any other gauge: "
             "its Thiessen polygon, or Voronoi cell. thiessen computes these cells, clips them to "
             "basins, weighs the gauges by the areas, and sums their readings to areal rainfall, "
             "step by step, gaps included.") +
         ".PP\n" +
         roff_paragraph(
             "Options may stand anywhere, before the command too; what follows -- is no option. "
             "The value of a long option may follow it after a blank or after =. A - in place of "
             "an output is the standard output.");
}

std::string commands_section(const Catalogue& commands) {
  std::string text = ".SH COMMANDS\n";
  for (const auto& command : commands.all()) {
    text += ".TP\n" + roff_bold("thiessen " + usage_of(*command)) + "\n" +
            roff_paragraph(as_sentence(command->description()));
  }
  return text;
}

std::string options_section(const Catalogue& commands) {
  const std::vector<SharedOption> options = shared_options(commands);
  std::string text =
      ".SH OPTIONS\n" + roff_paragraph(
                            "Of an option that not all commands have, the commands that "
                            "have it stand in parentheses.");
  for (const std::string& heading : headings(options)) {
    text += ".SS " + heading + "\n";
    for (const SharedOption& shared : options) {
      if (shared.option->group == heading) text += entry(shared, commands.all().size());
    }
  }
  return text;
}

std::string notes_sections(const Catalogue& commands) {
  std::string text;
  for (const auto& command : commands.all()) {
    if (command->notes().empty()) continue;
    std::string name = command->name();
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    text += ".SH " + name + "\n" + roff_verbatim(command->notes());
  }
  return text;
}

std::string report_section() {
  return ".SH THE PAGE OF A RUN\n" +
         roff_paragraph(
             "run writes report.html, one file that a browser opens without a server or a network: "
             "the map with a slider over the time steps, in which colours are of one scale for all "
             "steps (and for the means those of map.png); of each basin the steps as bars and "
             "their sum with its 95 % bar; tables of basins, weights, silent gauges and influence; "
             "what check says; version, options and the SHA-256 of each input file. It shows the "
             "steps of RAINFALL, also where --every makes totals of them. Cells and weights are "
             "those "
             "of the full network, at every step; who is silent at it stands below the map.") +
         ".PP\n" +
         roff_paragraph(
             "A long series is thinned, which the page says: some steps are shown as one, with the "
             "largest and the least value of each basin, and the map has the one with the most "
             "rain over all gauges. Above a million readings by gauge the map shows the means "
             "alone. rain.csv has all steps, or with --every their totals.");
}

std::string study_file_section() {
  return ".SH A STUDY AS A FILE\n" +
         roff_paragraph(
             "run writes study.toml beside its results: all that it was told but where they go, so "
             "that they can be had again with") +
         ".PP\n" + roff_verbatim("thiessen run --config results/study.toml -o again") + ".PP\n" +
         roff_paragraph(
             "Such a file may as well be written by hand. It is TOML: a line name = value for an "
             "option, by its long name without the dashes, or for an argument (stations, basins, "
             "rainfall). Texts and times stand in quotes; a flag is true or false; an option that "
             "may be repeated takes an array, [\"a\", \"b\"]. Case does not count in names, and _ "
             "is -. Relative names of files count from the folder of the file, wherever the "
             "program runs. What the command line gives stands in place of what the file has, and "
             "a notice says which. A name that is no option of the command is an error with its "
             "line. study.toml holds no password: PGPASSWORD or a .pgpass file gives it.");
}

std::string status_section() {
  std::string text = ".SH EXIT STATUS\n";
  const auto add = [&](const char* status, const char* meaning) {
    text += ".TP\n" + roff_bold(status) + "\n" + roff_paragraph(meaning);
  };
  add("0", "All is done.");
  add("1", "The data are at fault, or the machine; nothing is written.");
  add("2", "The command line is wrong.");
  add("130", "Interrupted; nothing is written.");
  return text + ".SH DIAGNOSTICS\n" +
         roff_paragraph(
             "A message is one line on the standard error, with file and line where they are "
             "known; a second line may give a hint. Every bad row of a file is told, up to 20.");
}

std::string others_section() {
  std::string text = ".SH FROM OTHER PROGRAMS\n" +
                     roff_paragraph(
                         "Pages in samples/, in the folder of the clone or in share/doc/thiessen "
                         "of an installation, begin each of these:");
  const auto add = [&](const char* name, const char* what) {
    text += ".TP\n" + roff_bold(name) + "\n" + roff_paragraph(what);
  };
  add("C++",
      "the library: #include <thiessen.h>, linked as thiessen::thiessen after "
      "find_package(thiessen) of CMake, or as pkg-config says of thiessen (samples/library).");
  add("Python",
      "the module thiessen, arrays in and out, built by pip from src/python of the clone "
      "(samples/python).");
  add("QGIS", "Processing scripts for cells, weights and areal rainfall (samples/qgis).");
  add("R", "results opened with sf and terra, and as data frames (samples/r).");
  add("PostGIS", "PG:... in place of a file: stations, basins, readings, and -o.");
  add("Array jobs", "an archive split by time, with GNU parallel or Slurm (samples/jobs).");
  return text;
}

std::string examples_section(const Catalogue& commands) {
  std::string text =
      ".SH EXAMPLES\n" +
      roff_paragraph(
          "Where samples/ is: in the folder of the clone; or beside a link to that of an "
          "installation, share/doc/thiessen/samples.");
  for (const auto& command : commands.all()) {
    text += ".PP\n" + roff_paragraph(as_sentence(command->description())) + ".PP\n" +
            roff_verbatim(std::string("thiessen ") + command->name() + " " + command->example());
  }
  return text;
}

}  // namespace

std::string manual(const Catalogue& commands) {
  return title() + beginning() + commands_section(commands) + options_section(commands) +
         notes_sections(commands) + report_section() + study_file_section() + files_sections() +
         others_section() + status_section() + examples_section(commands);
}

}  // namespace thiessen::cli
