#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <unistd.h>

#include "base/temporary_folder.h"
#include "cli/program.h"
#include "fuzzers/memory_file.h"
#include "gdal/drivers.h"
#include "gdal/layers/ods_file.h"
#include "gdal/layers/xlsx_file.h"

namespace thiessen::fuzzers {

/// What a run of the whole program, in this process, printed and how it ended.
struct WholeRun {
  int status;
  std::string out;
  std::string told;  ///< on the standard error
};

/// Has what is written to a standard stream, as long as it lives.
class Diverted {
 public:
  Diverted(int stream, std::FILE* file) : stream_(stream), file_(file), kept_(::dup(stream)) {
    std::fflush(file_);
    ::dup2(memory_number(), stream_);
  }
  ~Diverted() {
    std::fflush(file_);
    ::dup2(kept_, stream_);
    ::close(kept_);
  }
  std::string text() {
    std::cout.flush();
    std::fflush(file_);
    return memory_.take();
  }

 private:
  int memory_number() const {
    return std::stoi(memory_.name().substr(memory_.name().rfind('/') + 1));
  }

  int stream_;
  std::FILE* file_;
  int kept_;
  MemoryFile memory_;
};

inline WholeRun run_whole(std::vector<std::string> words) {
  words.insert(words.begin(), "thiessen");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  Diverted out(STDOUT_FILENO, stdout);
  Diverted told(STDERR_FILENO, stderr);
  const int status = cli::run_program(static_cast<int>(words.size()), arguments.data());
  return {status, out.text(), told.text()};
}

/// A command and the files that it reads.
struct Sample {
  std::string name;
  std::vector<std::string> words;
  std::map<std::string, std::string> files;
  std::vector<std::string> read;  ///< those of the files that are to be damaged
};

/// The worst exit status that a file of a sample may lead to: what stands in a file of options is
/// as what stands on the command line.
inline int worst_status(const Sample& sample) {
  return sample.files.contains("study.toml") ? 2 : 1;
}

/// The folder in which all samples run; the process stands in it from the first one on.
class RunFolder {
 public:
  static RunFolder& the_one() {
    static RunFolder workplace;
    return workplace;
  }

  /// Runs the sample on these files, which are those of the sample or damaged ones. What the run
  /// leaves is removed, and told in `left`.
  WholeRun run(const Sample& sample, const std::map<std::string, std::string>& files,
               std::set<std::string>* left = nullptr) {
    std::vector<std::string> words = sample.words;
    std::set<std::string> names;
    for (const auto& [name, bytes] : files) {
      const std::string fresh = fresh_name(name);
      std::replace(words.begin(), words.end(), name, fresh);
      folder_.write(fresh, bytes);
      names.insert(fresh);
    }
    const WholeRun ran = run_whole(std::move(words));
    for (const std::string& name : folder_.names()) {
      if (left != nullptr && !names.contains(name)) left->insert(name);
      std::filesystem::remove_all(folder_.path(name));
    }
    return ran;
  }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  RunFolder() { std::filesystem::current_path(folder_.path()); }

  /// GDAL remembers what is in an archive by its name, its size and the second of its making.
  std::string fresh_name(const std::string& name) {
    constexpr std::string_view packed[] = {".xlsx", ".ods", ".zip"};
    for (const std::string_view end : packed) {
      if (name.ends_with(end))
        return name.substr(0, name.size() - end.size()) + "_" + std::to_string(++runs_) +
               std::string(end);
    }
    return name;
  }

  TemporaryFolder folder_;
  std::size_t runs_ = 0;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path.string() + " cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Splits a command as a shell does, as far as tests/formats/formats.toml needs it.
inline std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  bool inside = false;
  char quote = '\0';
  for (const char c : text) {
    if (quote != '\0' ? c == quote : c == '"' || c == '\'') {
      quote = quote != '\0' ? '\0' : c;
      if (!inside) words.emplace_back();
      inside = true;
    } else if (c == ' ' && quote == '\0') {
      inside = false;
    } else {
      if (!inside) words.emplace_back();
      inside = true;
      words.back() += c;
    }
  }
  return words;
}

/// The published formats of tests/formats.
inline void add_published(const std::filesystem::path& formats, std::vector<Sample>& samples) {
  std::ifstream list(formats / "formats.toml");
  Sample sample;
  for (std::string line; std::getline(list, line);) {
    const auto value = [&](std::string_view key) {
      return line.starts_with(key) ? line.substr(key.size(), line.size() - key.size() - 1) : "";
    };
    if (const std::string folder = value("folder = \""); !folder.empty()) {
      sample = {folder, {}, {}, {}};
      for (const auto& entry : std::filesystem::directory_iterator(formats / folder)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".cdl")) continue;
        sample.files[name] = bytes_of(entry.path());
        if (name != "basin.geojson") sample.read.push_back(name);
      }
      std::sort(sample.read.begin(), sample.read.end());
    }
    if (const std::string command = value("command = '"); !command.empty()) {
      sample.words = split_words(command);
      samples.push_back(sample);
    }
  }
}

inline Sample sample_of(std::string name, const std::string& command,
                        std::map<std::string, std::string> files,
                        const std::vector<std::string>& read) {
  return {std::move(name), split_words(command), std::move(files), read};
}

/// A sample of each kind of file that the program reads. Layers are written by the program itself,
/// once.
inline std::vector<Sample> make_samples() {
  start_gdal();
  std::vector<Sample> samples;
  const std::string gauges =
      "id,lon,lat,elev\nA,10.1,50.1,112\nB,10.6,50.2,230\nC,10.3,50.7,341\nD,10.8,50.9,87\n";
  const std::string basins =
      "{\"type\":\"FeatureCollection\",\"features\":[\n{\"type\":\"Feature\",\"properties\":{"
      "\"basin\":\"east\",\"n\":1200},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[10.5,"
      "50]"
      ",[11,50],[11,51],[10.5,51],[10.5,50]]]}},\n{\"type\":\"Feature\",\"properties\":{\"basin\":"
      "\"west\",\"n\":900},\"geometry\":{\"type\":\"MultiPolygon\",\"coordinates\":[[[[10,50],[10."
      "5,"
      "50],[10.5,51],[10,51],[10,50]]]]}}]}\n";
  const std::string wkt = "id,WKT\nwest,\"POLYGON ((10 50, 10.5 50, 10.5 51, 10 51, 10 50))\"\n";
  const std::string wide =
      "time,A,B,C,D\n2020-01-01,1.25,2.5,0,10\n2020-01-02,0.5,,3.75,12.5\n2020-01-03,0,1,0,11\n";
  const std::string rows =
      "station;time;rain\nA;2020-01-01 06:00;1,25\nB;2020-01-01 06:00;2,5\nA;2020-01-01 "
      "07:00;0,5\n";
  const std::map<std::string, std::string> study = {{"s.csv", gauges}, {"b.geojson", basins}};
  const auto with = [&](std::map<std::string, std::string> more) {
    more.insert(study.begin(), study.end());
    return more;
  };
  samples.push_back(
      sample_of("csv and geojson", "weights s.csv b.geojson", study, {"s.csv", "b.geojson"}));
  samples.push_back(
      sample_of("wkt", "weights s.csv b.csv", {{"s.csv", gauges}, {"b.csv", wkt}}, {"b.csv"}));
  samples.push_back(
      sample_of("wide", "rain s.csv b.geojson r.csv", with({{"r.csv", wide}}), {"r.csv"}));
  samples.push_back(
      sample_of("long", "rain s.csv b.geojson r.csv", with({{"r.csv", rows}}), {"r.csv"}));
  samples.push_back(
      sample_of("findings", "rain s.csv b.geojson r.csv --exclude f.csv",
                with({{"r.csv", wide},
                      {"f.csv", "station,time,kind\nB,2020-01-01,high\nD,2020-01-03,high\n"}}),
                {"f.csv"}));
  samples.push_back(sample_of(
      "totals", "rain s.csv b.geojson r.csv --totals t.csv --observed-at 06:00",
      with({{"r.csv",
             "time,A,B\n2020-01-01T18:00,1,2\n2020-01-02T06:00,3,4\n2020-01-02T18:00,1,1\n"
             "2020-01-03T06:00,0,2\n"},
            {"t.csv", "time,C\n2020-01-02,24.5\n2020-01-03,12.25\n"}}),
      {"t.csv"}));
  samples.push_back(
      sample_of("options", "rain --config study.toml",
                with({{"r.csv", wide},
                      {"study.toml",
                       "stations = \"s.csv\"\nbasins = \"b.geojson\"\nrainfall = \"r.csv\"\n"
                       "decimals = 12\nmissing = [\"x\", \"-9\"]\n"}}),
                {"study.toml"}));
  samples.push_back(sample_of(
      "append", "rain s.csv b.geojson r.csv -o o.csv --append",
      with({{"r.csv", wide}, {"o.csv", "time,east,west\n2020-01-01,8.125,1.688\n"}}), {"o.csv"}));
  samples.push_back(sample_of("session", "tessel t.txt",
                              {{"t.txt",
                                "load p.csv\nprint\nadd 0.25 0.75\ndelete 0 10\nundo\n"
                                "cell 10 10\n"},
                               {"p.csv", "0,0\n10,0\n0,10\n10,10\n4.5,3.25\n"}},
                              {"t.txt", "p.csv"}));
  const TemporaryFolder& folder = RunFolder::the_one().folder();
  const auto made = [&](const std::string& command, const std::vector<std::string>& outputs) {
    for (const auto& [name, bytes] : study) folder.write(name, bytes);
    const WholeRun ran = run_whole(split_words(command));
    if (ran.status != 0) throw std::runtime_error(command + ": " + ran.told);
    std::map<std::string, std::string> files = {{"s.csv", gauges}};
    for (const std::string& name : outputs) files[name] = folder.read(name);
    for (const std::string& name : folder.names()) std::filesystem::remove_all(folder.path(name));
    return files;
  };
  for (const std::string kind : {"gpkg", "fgb", "kml"}) {
    samples.push_back(sample_of(kind, "weights s.csv c." + kind + " --basin-id station",
                                made("cells s.csv b.geojson -o c." + kind, {"c." + kind}),
                                {"c." + kind}));
  }
  samples.push_back(
      sample_of("shapefile", "weights s.csv c.shp --basin-id station",
                made("cells s.csv b.geojson -o c.shp", {"c.shp", "c.shx", "c.dbf", "c.prj"}),
                {"c.shp", "c.shx", "c.dbf", "c.prj"}));
  auto raster = made("map s.csv b.geojson -o n.tif --resolution 0.1", {"n.tif"});
  raster["b.geojson"] = basins;
  samples.push_back(
      sample_of("raster", "weights s.csv b.geojson --normals n.tif", std::move(raster), {"n.tif"}));
  const auto cell = [](const std::string& text) {
    return "<c t=\"inlineStr\"><is><t>" + text + "</t></is></c>";
  };
  write_xlsx(folder.path("r.xlsx"),
             {{"rain", "<row r=\"1\"><c t=\"s\"><v>0</v></c><c t=\"s\"><v>1</v></c>" + cell("B") +
                           "</row><row r=\"2\"><c s=\"1\"><v>43831</v></c><c><v>1.5</v></c><c><v>2"
                           "</v></c></row><row r=\"3\"><c s=\"1\"><v>43832</v></c><c><v>0.25</v>"
                           "</c><c><v>4</v></c></row>"}});
  samples.push_back(sample_of("xlsx", "rain s.csv b.geojson r.xlsx",
                              with({{"r.xlsx", folder.read("r.xlsx")}}), {"r.xlsx"}));
  const auto of_ods = [](const std::string& attributes, const std::string& text) {
    return "<table:table-cell office:value-type=" + attributes + "><text:p>" + text +
           "</text:p></table:table-cell>";
  };
  write_ods(folder.path("r.ods"),
            {{"rain", "<table:table-row>" + of_ods("\"string\"", "time") +
                          of_ods("\"string\"", "A") + "</table:table-row><table:table-row>" +
                          of_ods("\"date\" office:date-value=\"2020-01-01\"", "x") +
                          of_ods("\"float\" office:value=\"1.5\"", "1.5") + "</table:table-row>"}});
  samples.push_back(sample_of("ods", "rain s.csv b.geojson r.ods",
                              with({{"r.ods", folder.read("r.ods")}}), {"r.ods"}));
  void* const zip = CPLCreateZip(folder.path("r.zip").c_str(), nullptr);
  CPLCreateFileInZip(zip, "r.csv", nullptr);
  CPLWriteFileInZip(zip, wide.data(), static_cast<int>(wide.size()));
  CPLCloseFileInZip(zip);
  CPLCloseZip(zip);
  samples.push_back(sample_of("archive", "rain s.csv b.geojson r.zip",
                              with({{"r.zip", folder.read("r.zip")}}), {"r.zip"}));
  for (const std::string& name : folder.names()) std::filesystem::remove_all(folder.path(name));
  add_published(THIESSEN_FORMATS, samples);
  return samples;
}

inline const std::vector<Sample>& samples() {
  static const std::vector<Sample> made = make_samples();
  return made;
}

}  // namespace thiessen::fuzzers
