#pragma once

#include <optional>
#include <string_view>

namespace thiessen {

/// A kind of file that no command reads: what it is, and what to do about it.
struct FileKind {
  std::string_view name;  ///< "a PDF document"
  std::string_view hint;
};

/// Tells by its first bytes (a few thousand of them) what a file is that is not read; nothing where
/// it may be a CSV, JSON or any other that is.
std::optional<FileKind> unread_kind(std::string_view first_bytes);

/// Tells what an archive of these files is that is no archive of data to whoever made it: the
/// document of a word processor, for one. `has` tells whether a file of this name is in it.
template <typename Has>
std::optional<FileKind> unread_archive(Has&& has) {
  constexpr std::string_view hint = "save its table as .csv or .xlsx";
  if (has("word/document.xml")) return FileKind{"a text document (.docx)", hint};
  if (has("ppt/presentation.xml")) return FileKind{"a presentation (.pptx)", hint};
  return std::nullopt;
}

}  // namespace thiessen
