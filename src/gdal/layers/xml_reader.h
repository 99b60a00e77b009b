#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace thiessen {

/// The attributes of an element. Names are local: `r:id` is `id`.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  /// The value of an attribute; empty where it is not there.
  std::string_view operator[](std::string_view name) const;

 private:
  const char** pairs_;
};

/// Hears what stands in an XML document. Names of elements are local: `x:row` is `row`.
class XmlListener {
 public:
  virtual ~XmlListener() = default;
  virtual void begin(std::string_view element, const XmlAttributes& attributes) = 0;
  virtual void end(std::string_view element) = 0;
  virtual void text(std::string_view part) = 0;
};

/// Reads an XML document that may stand in an archive, bit by bit, by expat. A document type, and
/// with it every entity, is refused.
class XmlReader {
 public:
  /// `name` is the document as GDAL is given it, `file` as messages name it. The listener must
  /// outlive this object. Throws Error where it cannot be opened.
  XmlReader(const std::string& file, const std::string& name, XmlListener& listener);
  ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  /// Reads the next 64 kB; returns false at the end. Throws Error where the document is not whole,
  /// and what the listener throws.
  bool read_on();
  void read_all() {
    while (read_on()) {
    }
  }

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace thiessen
