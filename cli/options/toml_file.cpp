#include "cli/options/toml_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "base/number.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t largest = 1 << 20;  // bytes: a list of options is no larger

std::string whole_text(const std::string& path) {
  InputFile file(path);
  std::string text;
  std::vector<char> part(1 << 16);
  while (const std::size_t count = file.read(part)) {
    text.append(part.data(), count);
    if (text.size() > largest)
      throw Error({file.name(), 0, "this is larger than 1 MB, and no list of options", ""});
  }
  return text;
}

/// A number, a date or a time as a command line has it; nothing for an array or a table.
std::vector<std::string> texts_of(const toml::node& node) {
  if (const auto* text = node.as_string()) return {text->get()};
  if (const auto* number = node.as_integer()) return {std::to_string(number->get())};
  if (const auto* truth = node.as_boolean()) return {truth->get() ? "true" : "false"};
  if (const auto* number = node.as_floating_point()) {
    const double value = number->get();
    if (value - value == 0) return {shortest_text(value)};  // neither infinite nor NaN
  }
  std::ostringstream text;
  node.visit([&](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) text << *value;
  });
  return {text.str()};
}

std::size_t line_of(const toml::node& node) {
  return node.source().begin.line;
}

TomlSetting setting_of(const std::string& file, const std::string& key, const toml::node& node) {
  TomlSetting setting{key, line_of(node), {}, node.is_boolean(), node.is_string()};
  if (const auto* values = node.as_array()) {
    setting.is_text = true;
    for (const toml::node& value : *values) {
      if (value.is_array() || value.is_table() || value.is_boolean())
        throw Error({file, line_of(value), "an array of options holds texts and numbers", ""});
      setting.is_text = setting.is_text && value.is_string();
      const std::vector<std::string> texts = texts_of(value);
      setting.texts.insert(setting.texts.end(), texts.begin(), texts.end());
    }
  } else {
    setting.texts = texts_of(node);
  }
  for (const std::string& text : setting.texts) {  // it would end the name of a file
    if (text.find('\0') != std::string::npos)
      throw Error({file, setting.line, "a text with a NUL in it is no option's", ""});
  }
  return setting;
}

}  // namespace

std::vector<TomlSetting> read_toml(const std::string& path) {
  std::vector<TomlSetting> settings;
  try {
    const toml::table table = toml::parse(whole_text(path), path);
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      if (node.is_table() || node.is_array_of_tables()) {
        throw Error({path, line_of(node), "[" + name + "] is a table, and options stand in none",
                     "each option is a line of its own: name = value"});
      }
      settings.push_back(setting_of(path, name, node));
    }
  } catch (const toml::parse_error& error) {
    throw Error({path, error.source().begin.line,
                 "this is not TOML: " + std::string(error.description()),
                 "each option is a line: its name, =, and its value; texts and times stand in "
                 "quotes"});
  }
  std::stable_sort(settings.begin(), settings.end(),
                   [](const auto& a, const auto& b) { return a.line < b.line; });
  return settings;
}

std::string toml_text(std::string_view text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string written = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      written += {'\\', c};
    } else if (code < 0x20 || code == 0x7F) {
      written += std::string("\\u00") + digits[code / 16] + digits[code % 16];
    } else {
      written += c;
    }
  }
  return written + '"';
}

}  // namespace thiessen::cli
