#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/utf8.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/whole_runs.h"

namespace thiessen::fuzzers {
namespace {

/// Requires an end that a user can do something about, and no file but those that are expected.
void require_end(const WholeRun& ran, int worst, const std::set<std::string>& left,
                 const std::string& expected = "") {
  require(ran.status >= 0 && ran.status <= worst, "the exit status " + std::to_string(ran.status));
  require(ran.told.find("a fault of the program itself") == std::string::npos, ran.told);
  require(ran.status == 0 || ran.told.find("thiessen: error: ") != std::string::npos,
          "a failure without an error");
  require(!find_invalid_utf8(ran.told), "a message that is not UTF-8");
  for (const std::string& name : left) {
    require(name == expected && ran.status == 0,
            "the file " + name + " is left with status " + std::to_string(ran.status));
  }
  require(expected.empty() || ran.status != 0 || !left.empty(), expected + " is not there");
}

void run_on(const Sample& sample, const std::map<std::string, std::string>& files, int worst) {
  std::set<std::string> left;
  const WholeRun ran = RunFolder::the_one().run(sample, files, &left);
  require_end(ran, worst, left);
}

/// Any bytes as one of a sample's files.
void read_bytes(Bytes& bytes) {
  const Sample& sample = bytes.one_of(samples());
  auto files = sample.files;
  files[bytes.one_of(sample.read)] = bytes.rest();
  run_on(sample, files, worst_status(sample));
}

/// A sample's file of which bytes are changed, left out or put in, or whose end is cut off.
void read_damaged(Bytes& bytes) {
  const Sample& sample = bytes.one_of(samples());
  auto files = sample.files;
  std::string& file = files[bytes.one_of(sample.read)];
  while (!bytes.empty() && !file.empty()) {
    const std::size_t step = bytes.next();
    const std::size_t at = (bytes.next() * std::size_t{256} + bytes.next()) % file.size();
    const char byte = static_cast<char>(bytes.next());
    switch (step % 8) {
      case 0:
        file.insert(at, 1, byte);
        break;
      case 1:
        file.erase(at, 1 + static_cast<unsigned char>(byte) % 16);
        break;
      case 2:
        file.insert(at, file.substr(at, static_cast<unsigned char>(byte)));
        break;
      case 3:
        if (step >= 128) file.resize(at);
        break;
      default:
        file[at] = byte;
    }
  }
  run_on(sample, files, worst_status(sample));
}

/// A word of the command line, as anybody may write it.
std::string word_of(std::string_view text) {
  std::string word(text);
  std::erase(word, '\0');
  return word;
}

constexpr std::string_view gauges =
    "id,lon,lat,name\nA,10.1,50.1,a\nB,10.6,50.2,b\nC,10.3,50.7,c\n";
constexpr std::string_view basins =
    "id,WKT\nwest,\"POLYGON ((10 50, 10.5 50, 10.5 51, 10 51, 10 50))\"\n";
constexpr std::string_view rain = "time,A,B,C\n2020-01-01,1.25,2.5,0\n2020-01-02,0.5,,3.75\n";

/// Any name, but of a file in the same folder, for an output.
void name_output(Sample& sample, std::string name) {
  std::erase(name, '/');
  sample.words.insert(sample.words.end(), {"-o", "o." + name});
  if (sample.words[0] == "weights") sample.words[0] = "cells";
  std::set<std::string> left;
  const WholeRun ran = RunFolder::the_one().run(sample, sample.files, &left);
  std::erase_if(left, [&](const std::string& file) {
    return ran.status == 0 && (file.starts_with("o.") || file == "o");
  });
  require_end(ran, 2, left);
}

void read_option(Bytes& bytes) {
  constexpr std::array of_weights = {"--crs",
                                     "--basins-crs",
                                     "--plane",
                                     "--stations-where",
                                     "--basins-where",
                                     "--id",
                                     "--x",
                                     "--basin-id",
                                     "--encoding",
                                     "--separator",
                                     "--stations-layer",
                                     "--tolerance",
                                     "--with",
                                     "--normal-field"};
  constexpr std::array of_rain = {
      "--time-format", "--from",        "--to",        "--missing",
      "--trace",       "--every",       "--max",       "--units",
      "--time-field",  "--value-field", "--from-unit", "--rainfall-where",
      "--day-start",   "--stamp",       "--decimals",  "--method"};
  const bool rains = bytes.below(2) == 1;
  const char* const option = rains ? bytes.one_of(of_rain) : bytes.one_of(of_weights);
  Sample sample{"option",
                {rains ? "rain" : "weights", "s.csv", "b.csv"},
                {{"s.csv", std::string(gauges)}, {"b.csv", std::string(basins)}},
                {}};
  if (rains) {
    sample.words.emplace_back("r.csv");
    sample.files.emplace("r.csv", rain);
  }
  if (bytes.below(16) == 0) return name_output(sample, word_of(bytes.rest()));
  sample.words.insert(sample.words.end(), {option, word_of(bytes.rest())});
  run_on(sample, sample.files, 2);
}

std::string quoted_field(std::string_view text) {
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

/// Names of gauges and basins, a title, and whatever a command makes of them.
void write_names(Bytes& bytes) {
  constexpr std::array<std::string_view, 16> commands = {
      "map s.csv b.csv -o o.png --size 200x150",
      "map s.csv b.csv -o o.svg --size 200x150",
      "map s.csv b.csv r.csv -o o.png --size 200x150 --label name",
      "map s.csv b.csv -o o.tif --resolution 0.1",
      "cells s.csv b.csv -o o.geojson --attributes",
      "cells s.csv b.csv -o o.gpkg",
      "cells s.csv b.csv -o o.fgb",
      "cells s.csv b.csv -o o.kml --attributes",
      "weights s.csv b.csv -o o.csv",
      "rain s.csv b.csv r.csv --format hype -o o.txt",
      "rain s.csv b.csv r.csv --format swmm -o o.dat",
      "rain s.csv b.csv r.csv --format pi-xml --units mm -o o.xml",
      "rain s.csv b.csv r.csv --format netcdf --units mm -o o.nc",
      "rain s.csv b.csv r.csv --format swat -o o.pcp",
      "rain s.csv b.csv r.csv --long --every month -o o.csv",
      "run s.csv b.csv r.csv -o o"};
  const std::string_view command = bytes.one_of(commands);
  const std::string first = quoted_field(bytes.until('\xFE'));
  const std::string second = quoted_field(bytes.until('\xFE'));
  const std::string basin = quoted_field(bytes.until('\xFE'));
  const std::string title = word_of(bytes.rest());
  Sample sample{"names", split_words(command), {}, {}};
  if (command.starts_with("map") && command.find(".tif") == std::string_view::npos &&
      !title.empty())
    sample.words.push_back("--title=" + title);
  sample.files = {
      {"s.csv", "id,lon,lat,name\n" + first + ",10.1,50.1," + second + "\n" + second +
                    ",10.6,50.2," + first + "\n"},
      {"b.csv", "id,WKT\n" + basin + ",\"POLYGON ((10 50, 10.5 50, 10.5 51, 10 51, 10 50))\"\n"},
      {"r.csv", "time,station,rain\n2020-01-01," + first + ",1.5\n2020-01-01," + second + ",2\n"}};
  std::set<std::string> left;
  const WholeRun ran = RunFolder::the_one().run(sample, sample.files, &left);
  std::string expected;
  for (const std::string& word : sample.words) {
    if (word == "o" || word.starts_with("o.")) expected = word;
  }
  if (ran.status == 0 && expected == "o.tif")
    std::erase_if(
        left, [](const std::string& name) { return name == "o.tif.aux.xml" || name == "o.qml"; });
  require_end(ran, 2, left, expected);
}

}  // namespace

void fuzz_program(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  switch (bytes.below(8)) {
    case 0:
      return write_names(bytes);
    case 1:
    case 2:
      return read_option(bytes);
    case 3:
      return read_damaged(bytes);
    default:
      return read_bytes(bytes);
  }
}

}  // namespace thiessen::fuzzers
