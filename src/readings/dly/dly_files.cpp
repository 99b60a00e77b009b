#include "readings/dly/dly_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/error.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

namespace fs = std::filesystem;

bool ends_in_dly(const std::string& name) {
  return lower_case(name).ends_with(".dly");
}

bool is_folder(const std::string& name) {
  std::error_code ignored;
  return fs::is_directory(name, ignored);
}

}  // namespace

bool is_dly(const std::string& rainfall) {
  return rainfall != "-" && (ends_in_dly(rainfall) || is_folder(rainfall));
}

std::vector<std::string> dly_files(const std::string& rainfall) {
  if (!is_folder(rainfall)) return {rainfall};
  std::vector<std::string> files;
  std::error_code fault;
  for (fs::directory_iterator entry(rainfall, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    if (ends_in_dly(entry->path().filename().string())) files.push_back(entry->path().string());
  }
  if (fault) throw Error(Message{rainfall, 0, "cannot read: " + fault.message(), ""});
  if (files.empty()) {
    throw Error(Message{rainfall, 0, "is a folder without a .dly file",
                        "readings are a table, or .dly files of GHCN-Daily"});
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace thiessen
