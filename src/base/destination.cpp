#include "base/destination.h"

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <string_view>

#include "base/number.h"

namespace thiessen {
namespace {

constexpr std::string_view hidden_prefix = ".thiessen-";
constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz012345";
constexpr std::size_t random_letters = 16;

bool same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

bool is_input(const struct stat& status, const OutputRules& rules) {
  return std::any_of(rules.inputs.begin(), rules.inputs.end(), [&](const std::string& input) {
    struct stat other = {};
    const int failed = input == "-" ? ::fstat(STDIN_FILENO, &other) : ::stat(input.c_str(), &other);
    return failed == 0 && same_file(status, other);
  });
}

Destination::Kind kind_of(const std::string& path, const struct stat& status, bool link) {
  if (S_ISDIR(status.st_mode)) throw system_error(path, "cannot write", EISDIR);
  if (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode)) return Destination::Kind::stream;
  if (!S_ISREG(status.st_mode)) {
    throw Error(Message{path, 0, "cannot write: neither a file nor a pipe", ""});
  }
  return link ? Destination::Kind::link : Destination::Kind::file;
}

void refuse_unless_replaceable(const std::string& path, const struct stat& status,
                               const OutputRules& rules) {
  if (is_input(status, rules)) {
    throw Error(Message{"", 0, path + " is an input of this run, and would be lost",
                        "give the output another name"});
  }
  if (!rules.overwrite) {
    throw Error(Message{"", 0, path + " exists already", setting("overwrite") + " replaces it"});
  }
}

}  // namespace

Destination examine_destination(const std::string& path, const OutputRules& rules) {
  if (path.empty()) throw Error(Message{"", 0, "the name of an output is empty", ""});
  if (path.back() == '/') throw system_error(path, "cannot write", EISDIR);
  Destination found;
  struct stat itself = {};
  if (::lstat(path.c_str(), &itself) != 0) {
    if (errno == ENOENT) return found;
    throw system_error(path, "cannot write", errno);
  }
  const bool link = S_ISLNK(itself.st_mode);
  if (::stat(path.c_str(), &found.status) != 0) {
    throw system_error(path, "cannot write: a symbolic link that leads nowhere", errno);
  }
  found.kind = kind_of(path, found.status, link);
  if (found.kind != Destination::Kind::stream) {
    refuse_unless_replaceable(path, found.status, rules);
  }
  return found;
}

bool goes_to_stream(const std::string& path) {
  struct stat status = {};
  if (path == "-" || standing_descriptor(path)) return true;
  return ::stat(path.c_str(), &status) == 0 &&
         (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode));
}

std::optional<int> standing_descriptor(const std::string& path) {
  if (path == "/dev/stdin") return STDIN_FILENO;
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const Parsed<std::size_t> number = parse_size(std::string_view(path).substr(folder.size()));
    if (number && number.value < 1'000'000) return static_cast<int>(number.value);
  }
  return std::nullopt;
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

std::string name_in_folder(const std::string& path) {
  return path.substr(path.rfind('/') + 1);  // npos + 1 is 0
}

std::string fresh_name(const std::string& folder) {
  std::array<unsigned char, random_letters> random = {};
  if (::getrandom(random.data(), random.size(), GRND_NONBLOCK) < 0) {
    auto ticks =
        static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count() ^
                                   (std::int64_t{::getpid()} << 40));
    for (unsigned char& part : random) {
      part = static_cast<unsigned char>(ticks >> 59);
      ticks = ticks * 6364136223846793005u + 1442695040888963407u;
    }
  }
  std::string name = folder + "/";
  name += hidden_prefix;
  for (const unsigned char part : random) name += letters[part % letters.size()];
  return name;
}

bool is_fresh_name(std::string_view name) {
  return name.size() == fresh_name_length() && name.starts_with(hidden_prefix) &&
         name.find_first_not_of(letters, hidden_prefix.size()) == std::string_view::npos;
}

std::size_t fresh_name_length() {
  return hidden_prefix.size() + random_letters;
}

}  // namespace thiessen
