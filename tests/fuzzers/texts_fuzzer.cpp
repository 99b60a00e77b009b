#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/destination.h"
#include "base/error.h"
#include "base/number.h"
#include "base/secrets.h"
#include "base/utf8.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/message_laws.h"
#include "map/ink/unicode.h"
#include "text/field_names.h"
#include "text/file_kind.h"
#include "text/known_names.h"
#include "text/similar_texts.h"

namespace thiessen::fuzzers {
namespace {

std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// Requires that the two readers of UTF-8, of files and of pictures, agree on what it is.
void read_characters(std::string_view text) {
  const std::optional<std::size_t> invalid = find_invalid_utf8(text);
  const Utf8Prefix prefix = valid_utf8_prefix(text);
  require(prefix.valid == invalid.value_or(text.size()), "another end of what is UTF-8");
  require(!find_invalid_utf8(text.substr(0, prefix.valid)), "a valid beginning that is not");
  require(!prefix.truncated || text.size() - prefix.valid < 4, "a character of more than 4 bytes");

  const std::u32string shown = displayable(text);
  constexpr std::string_view replacement = "\xEF\xBF\xBD";
  const auto replaced = static_cast<std::size_t>(std::count(shown.begin(), shown.end(), U'\uFFFD'));
  require((replaced > count_of(text, replacement)) == invalid.has_value(),
          "another notion of UTF-8 in pictures");
  const std::string written = to_utf8(shown);
  require(!find_invalid_utf8(written) && displayable(written) == shown,
          "another text once written and read again");
  for (const std::size_t length : {std::size_t{0}, std::size_t{3}, std::size_t{12}}) {
    const std::u32string cut = shortened(shown, length);
    require(cut.size() <= length + 1 && (shown.size() > length || cut == shown), "cut elsewhere");
  }
  std::u32string in_runs;
  for (const DirectedRun& run : directed_line(shown).runs) in_runs += run.text;
  std::u32string all = shown;
  std::sort(all.begin(), all.end());
  std::sort(in_runs.begin(), in_runs.end());
  require(in_runs == all, "runs that lose or gain a character");
}

/// Requires that what messages show of a text is one line of UTF-8 that a terminal does not obey.
void show(std::string_view text) {
  const std::string shown = printable(text);
  require(printable(shown) == shown, "shown otherwise the second time");
  require_sentences(Error({"f.csv", 1, "text " + quoted(text, 40), {}}));
  require_sentences(Error({std::string(text) + "x", 1, "text", quoted(text)}));
  for (const std::size_t longest : {std::size_t{0}, std::size_t{7}, std::size_t{400}}) {
    const std::string cut = quoted(text, longest);
    require(cut.size() <= longest + 5 && cut.front() == '\'' && cut.back() == '\'',
            "more than the longest text in quotes");
    require(find_invalid_utf8(text) || !find_invalid_utf8(cut), "cut within a character");
  }
  const std::string_view bare = trimmed(text);
  require(trimmed(bare) == bare && text.find(bare) != std::string_view::npos, "trimmed twice");
  require(equal_ignoring_case(text, lower_case(text)), "another text in lower case");
}

/// Requires that names that are looked for are found, and that what is said of them is text.
void look_up(Bytes& bytes) {
  std::vector<std::string> header;
  while (!bytes.empty() && header.size() < 12) header.emplace_back(bytes.until('\n'));
  if (header.empty()) return;
  const std::string wanted = header.back();
  const std::size_t found = require_field(header, wanted, setting("id"), "f.csv", 1);
  require(header[found] == wanted, "another field of this very name");
  header.pop_back();
  try {
    const std::size_t like = require_field(header, wanted, setting("id"), "f.csv", 1);
    require(same_name(header[like], wanted), "another field");
  } catch (const Error& error) {
    require_placed(error, "f.csv", 1);
  }
  const auto id = find_field(header, known::station_ids);
  for (const std::string& name : header)
    require(id || !same_name(name, known::station_ids[0]), "a name that is not found");

  SimilarTexts similar(wanted);
  for (const std::string& name : header) similar.offer(name);
  require(similar.found().size() <= 3, "more than three similar texts");
  for (const std::string& name : similar.found())
    require(std::find(header.begin(), header.end(), name) != header.end(), "a text of nobody's");
  require_sentences(Error({"f.csv", 1, "x" + did_you_mean(similar.found()) + listed(header), {}}));
  const std::string& first = header.empty() ? wanted : header.front();
  const std::size_t distance = text_distance(first, wanted);
  require(distance == text_distance(wanted, first), "a distance that is longer one way");
  require((distance == 0) == (first == wanted), "no distance of two texts");
  require(distance <= std::max(first.size(), wanted.size()), "a distance beyond both texts");
}

/// Requires that texts that are taken for numbers are numbers.
void guess_type(Bytes& bytes) {
  FieldTypeGuess guess;
  std::vector<std::string> texts;
  while (!bytes.empty() && texts.size() < 8) texts.emplace_back(bytes.until('\n'));
  for (const std::string& text : texts) guess.see(text);
  if (guess.type() == FieldType::text) return;
  for (const std::string& text : texts) {
    const auto number = parse_number(text);
    require(text.empty() || number, "taken for a number: " + text);
    if (text.empty() || guess.type() == FieldType::real) continue;
    require(std::to_string(std::stoll(text)) == text || text == "-0", "taken for whole: " + text);
  }
}

/// Requires that names of files, which hold any bytes but NUL, come apart and together again.
void part_path(std::string_view text) {
  const std::string path(text.substr(0, text.find('\0')));
  const std::string folder = folder_of(path);
  const std::string name = name_in_folder(path);
  require(!folder.empty() && name.find('/') == std::string::npos,
          "no folder, or a folder too many");
  require(path.ends_with(name), "another name than the path's last");
  const std::optional<int> number = standing_descriptor(path);
  require(!number || *number >= 0, "a descriptor of a number below 0");
  require(!number || path.starts_with("/"), "a descriptor by another name");
}

/// Requires that no password is shown that is told in one of the ways that are known, whatever
/// stands round it.
void hide_passwords(Bytes& bytes) {
  const std::string before(bytes.until('\n'));
  std::string secret;
  for (const char c : bytes.until('\n'))
    if (c >= 'A' && c <= 'Z') secret += c;
  const std::string after(bytes.until('\n'));
  // What stands before may tell a password of its own, which the other would be a part of.
  if (secret.size() < 4 || lower_case(before).find("password") != std::string::npos) return;
  require(without_password("PG:host=h password=" + secret + " 1 user=u") ==
              "PG:host=h password=*** user=u",
          "a password with a blank");
  struct Telling {
    std::string connection;
    std::string password;
  };
  const std::string two_words = secret + " 1";
  for (const Telling& told : {Telling{"password=" + secret + " ", secret},
                              Telling{"Password = '" + two_words + "' ", two_words},
                              Telling{"p://user:" + secret + "@host ", secret}}) {
    const std::string sentence = lower_case(before) + " " + told.connection + lower_case(after);
    require(without_passwords(sentence).find(secret) == std::string::npos,
            "a password in a sentence: " + printable(sentence));
    require(without_password(sentence).find(secret) == std::string::npos,
            "a password in a connection: " + printable(sentence));
    const std::string repeated = lower_case(before) + told.password + lower_case(after);
    require(without_secrets(repeated, told.connection).find(secret) == std::string::npos,
            "a password that is repeated: " + printable(repeated));
  }
}

/// Requires that what is said of a file of a kind that is not read is text, and that beginnings of
/// tables and of JSON are of none of these kinds.
void know_kinds(std::string_view text) {
  for (const std::string& whole : {std::string(text), "<?xml " + std::string(text)}) {
    if (const auto kind = unread_kind(whole))
      require_sentences(Error({"f", 0, std::string(kind->name), std::string(kind->hint)}));
  }
  const bool is_plain = text.find("Standard ") == std::string_view::npos &&
                        text.find("ustar") == std::string_view::npos;
  for (const char* beginning : {"id,", "{\"", "1.5,", "\xEF\xBB\xBFid;"})
    require(!is_plain || !unread_kind(beginning + std::string(text)), "a table that is not read");
}

}  // namespace

void fuzz_texts(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  switch (bytes.below(7)) {
    case 0:
      return read_characters(bytes.rest());
    case 1:
      return show(bytes.rest());
    case 2:
      return look_up(bytes);
    case 3:
      return guess_type(bytes);
    case 4:
      return hide_passwords(bytes);
    case 5:
      return know_kinds(bytes.rest());
    default:
      return part_path(bytes.rest());
  }
}

}  // namespace thiessen::fuzzers
