#include "cli/session/loaded_file.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "tessellation/topology_table_reader.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t chunk = std::size_t{4} << 10;
constexpr std::size_t longest_beginning = std::size_t{64} << 10;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The first line that is neither blank nor a comment; nothing where it has not come whole.
std::optional<std::string_view> first_line(std::string_view text, bool is_all) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\r\n");
    if (end == std::string_view::npos && !is_all) return std::nullopt;
    const std::string_view line = text.substr(0, end);
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != std::string_view::npos && line[begin] != '#') return line;
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return is_all ? std::optional<std::string_view>("") : std::nullopt;
}

}  // namespace

LoadedFile::LoadedFile(const std::string& name) : file_(name) {
  bool is_all = false;
  std::optional<std::string_view> line;
  while (!line) {
    const std::size_t before = beginning_.size();
    beginning_.resize(before + chunk);
    const std::size_t count = file_.read({beginning_.data() + before, chunk});
    beginning_.resize(before + count);
    is_all = count == 0 || beginning_.size() >= longest_beginning;
    line = first_line(beginning_, is_all);
  }
  is_table_ = TopologyTableReader<2>::begins_table(*line);
}

InputFile LoadedFile::input() && {
  const std::string name = file_.name();
  auto file = std::make_shared<InputFile>(std::move(file_));
  return InputFile(name, [file, beginning = std::move(beginning_),
                          at = std::size_t{0}](std::span<char> into) mutable {
    if (at == beginning.size()) return file->read(into);
    const std::size_t count = std::min(into.size(), beginning.size() - at);
    std::memcpy(into.data(), beginning.data() + at, count);
    at += count;
    return count;
  });
}

}  // namespace thiessen::cli
