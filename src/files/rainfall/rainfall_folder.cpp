#include "files/rainfall/rainfall_folder.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>
#include <system_error>

#include "base/utf8.h"
#include "files/rainfall/rainfall_content.h"
#include "gdal/layers/formats.h"
#include "gdal/layers/opening.h"

namespace thiessen {
namespace {

namespace fs = std::filesystem;

using FileNames = std::vector<std::string>;

bool is_folder(const std::string& name) {
  std::error_code ignored;
  return name != "-" && fs::is_directory(name, ignored);
}

std::string last_of(const std::string& name) {
  return fs::path(name).filename().string();
}

/// The last parts of some names, for a message.
std::string listed_names(const FileNames& files) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(files.size(), most); ++i) {
    if (i > 0) text += i + 1 == files.size() ? " and " : ", ";
    text += last_of(files[i]);
  }
  if (files.size() > most) text += " and " + std::to_string(files.size() - most) + " more";
  return text;
}

std::string one_or_several(const FileNames& names, const char* one, const char* several) {
  return names.size() == 1 ? one : several;
}

bool has_extension(const std::string& name, std::string_view extension) {
  return lower_case(name).ends_with(extension);
}

bool is_dly_file(const std::string& name) {
  return has_extension(name, ".dly");
}

/// Whether a zip may hold a file of a format that is read. One that is damaged may: whoever reads
/// it says so.
bool holds_tables(const std::string& zip) {
  try {
    if (!tables_in_zip(zip).empty()) return true;
  } catch (const Error&) {
    return true;
  }
  try {
    read_by_gdal(zip);
    return true;  // a spreadsheet, or no zip
  } catch (const Error&) {
    return false;
  }
}

/// Whether a file is of a format that is read, be it packed or not. The other files of a shapefile
/// beside its .shp do not count.
bool is_read(const std::string& name, const FileNames& names) {
  const std::string lower = lower_case(name);
  if (lower.ends_with(".zip")) return holds_tables(name);
  for (const std::string_view extension : {".pcp", ".cli", ".nc"})  // which GDAL's layers have not
    if (lower.ends_with(extension)) return rainfall_content(name) == RainfallContent::readings;
  const bool packed = lower.ends_with(".gz");
  if (format_by_extension(packed ? lower.substr(0, lower.size() - 3) : lower) == nullptr)
    return false;
  return !lower.ends_with(".dbf") ||
         std::none_of(names.begin(), names.end(), [&](const std::string& other) {
           return lower_case(other) == lower.substr(0, lower.size() - 4) + ".shp";
         });
}

fs::path real_path(const std::string& name) {
  std::error_code ignored;
  return fs::canonical(name, ignored);
}

/// Whether two files are one, or the first is part of the second, a shapefile.
bool is_part_of(const fs::path& file, const fs::path& other) {
  if (file.empty() || other.empty()) return false;
  if (file == other) return true;
  constexpr std::string_view sides[] = {".dbf", ".shx", ".prj", ".cpg", ".sbn",
                                        ".sbx", ".qpj", ".qix", ".qmd"};
  return has_extension(other.string(), ".shp") &&
         fs::path(file).replace_extension() == fs::path(other).replace_extension() &&
         std::ranges::find(sides, lower_case(file.extension().string())) != std::end(sides);
}

/// What lies in a folder, sorted by what is done with it.
class FolderOfReadings {
 public:
  FolderOfReadings(const std::string& folder, const FileNames& beside)
      : folder_(folder), beside_(beside) {
    find_entries();
    leave_out_inputs();
  }

  FileNames files(Warnings& warnings) {
    for (const std::string& name : entries_) {
      const bool counts =
          is_read(name, entries_) && rainfall_content(name) != RainfallContent::none;
      (counts ? files_ : others_).push_back(name);
    }
    if (std::any_of(entries_.begin(), entries_.end(), is_dly_file)) {
      tell_beside_dly(warnings);
      return {folder_};
    }
    keep_lists();
    require_some();
    tell(warnings);
    return std::move(files_);
  }

 private:
  void find_entries() {
    std::error_code fault;
    for (fs::directory_iterator entry(folder_, fault), end; !fault && entry != end;
         entry.increment(fault)) {
      std::error_code ignored;
      const std::string name = entry->path().string();
      if (last_of(name).starts_with('.')) continue;
      const fs::file_type type = entry->status(ignored).type();
      if (type == fs::file_type::directory) {
        folders_.push_back(name);
      } else if (type == fs::file_type::regular || type == fs::file_type::not_found) {
        entries_.push_back(name);  // a link to nothing is an error, told where it is opened
      } else {
        others_.push_back(name);  // a pipe or a device might be waited for
      }
    }
    if (fault) throw Error(Message{folder_, 0, "cannot read: " + fault.message(), ""});
    std::sort(entries_.begin(), entries_.end());
    std::sort(folders_.begin(), folders_.end());
  }

  /// Takes out the files of stations and basins. A table of readings may be the one of stations
  /// too.
  void leave_out_inputs() {
    std::vector<fs::path> inputs;
    for (const std::string& name : beside_) inputs.push_back(real_path(name));
    const auto is_input = [&](const std::string& name) {
      const fs::path path = real_path(name);
      return std::ranges::any_of(inputs,
                                 [&](const fs::path& input) { return is_part_of(path, input); }) &&
             rainfall_content(name) != RainfallContent::readings;
    };
    std::copy_if(entries_.begin(), entries_.end(), std::back_inserter(left_out_), is_input);
    std::erase_if(entries_, [&](const std::string& name) {
      return std::ranges::find(left_out_, name) != left_out_.end();
    });
  }

  void pass_over(const std::string& name) {
    std::erase(files_, name);
    others_.push_back(name);
  }

  /// Has a list of files stand for these. Lists of other weather are passed over with their files,
  /// which may look like those of rain.
  void keep_lists() {
    FileNames lists;
    for (const std::string& name : FileNames(files_)) {
      if (lists_no_rain(name)) {
        pass_over(name);
      } else if (!files_listed_in(name).empty()) {
        lists.push_back(name);
      }
    }
    if (lists.size() > 1) choose_among(lists);
    const std::set<fs::path> listed = listed_in(lists);
    std::erase_if(files_,
                  [&](const std::string& name) { return listed.contains(real_path(name)); });
  }

  static std::set<fs::path> listed_in(const FileNames& lists) {
    std::set<fs::path> listed;
    for (const std::string& list : lists) {
      for (const std::string& name : files_listed_in(list)) listed.insert(real_path(name));
    }
    return listed;
  }

  /// Leaves of several lists the one that is called as that of rain is.
  void choose_among(FileNames& lists) {
    FileNames of_rain;
    std::copy_if(
        lists.begin(), lists.end(), std::back_inserter(of_rain),
        [](const std::string& name) { return lower_case(last_of(name)).starts_with("pcp"); });
    if (of_rain.size() != 1) {
      throw Error(
          Message{folder_, 0,
                  "is a folder with several lists of files, each of which may be of rain: " +
                      listed_names(lists),
                  "name one as " + input("rainfall")});
    }
    std::erase(lists, of_rain.front());
    const std::set<fs::path> of_others = listed_in(lists);
    for (const std::string& name : FileNames(files_)) {
      const bool is_other_list = std::ranges::find(lists, name) != lists.end();
      if (is_other_list || of_others.contains(real_path(name))) pass_over(name);
    }
    lists = of_rain;
  }

  void require_some() const {
    if (!files_.empty()) return;
    std::string text = "is a folder without a file of readings";
    if (!left_out_.empty()) text += " beside " + listed_names(left_out_);
    if (!folders_.empty()) {
      throw Error(Message{folder_, 0,
                          text + ", and what lies in " +
                              one_or_several(folders_, "a folder", "folders") +
                              " in it does not count",
                          "name the folder that holds them"});
    }
    throw Error(Message{folder_, 0, text, "readings are tables, or .dly files of GHCN-Daily"});
  }

  /// Tells what else may hold readings where .dly files do.
  void tell_beside_dly(Warnings& warnings) const {
    FileNames passed = files_;
    passed.insert(passed.end(), folders_.begin(), folders_.end());
    if (passed.empty()) return;
    warnings.add_notice({folder_, 0,
                         listed_names(passed) + one_or_several(passed, " is", " are") +
                             " passed over: of a folder with .dly files these alone are read",
                         ""});
  }

  void tell(Warnings& warnings) {
    std::sort(others_.begin(), others_.end());
    if (!left_out_.empty()) {
      warnings.add_notice({folder_, 0,
                           listed_names(left_out_) + one_or_several(left_out_, " is", " are") +
                               " given as " + input("stations") + " or " + input("basins") +
                               ", and left out of its readings",
                           ""});
    }
    if (!others_.empty()) {
      warnings.add_notice({folder_, 0,
                           listed_names(others_) + one_or_several(others_, " holds", " hold") +
                               " no readings, and" + one_or_several(others_, " is", " are") +
                               " passed over",
                           ""});
    }
    if (!folders_.empty()) {
      warnings.add_notice({folder_, 0,
                           one_or_several(folders_, "its folder ", "its folders ") +
                               listed_names(folders_) + one_or_several(folders_, " is", " are") +
                               " passed over: of a folder the files count that lie right in it",
                           ""});
    }
  }

  const std::string& folder_;
  const FileNames& beside_;
  FileNames entries_;
  FileNames folders_;
  FileNames left_out_;
  FileNames files_;
  FileNames others_;
};

}  // namespace

std::vector<std::string> rainfall_files(const std::vector<std::string>& named,
                                        const std::vector<std::string>& beside,
                                        Warnings& warnings) {
  std::vector<std::string> files;
  for (const std::string& name : named) {
    if (!is_folder(name)) {
      files.push_back(name);
      continue;
    }
    for (std::string& file : FolderOfReadings(name, beside).files(warnings))
      files.push_back(std::move(file));
  }
  return files;
}

}  // namespace thiessen
