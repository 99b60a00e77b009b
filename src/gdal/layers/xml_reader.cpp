#include "gdal/layers/xml_reader.h"

#include <expat.h>

#include <exception>
#include <utility>
#include <vector>

#include "base/error.h"
#include "gdal/layers/vsi_bytes.h"

namespace thiessen {
namespace {

constexpr std::size_t bytes_at_once = std::size_t{64} << 10U;

std::string_view local(std::string_view name) {
  return name.substr(name.rfind(':') + 1);
}

}  // namespace

std::string_view XmlAttributes::operator[](std::string_view name) const {
  for (const char** pair = pairs_; *pair != nullptr; pair += 2) {
    if (local(pair[0]) == name) return pair[1];
  }
  return {};
}

struct XmlReader::Parser {
  std::string file;
  VsiBytes bytes;
  XmlListener& listener;
  XML_Parser expat;
  std::vector<char> buffer;
  std::exception_ptr fault;  // expat is C: an exception has to wait until it has returned
  bool has_type = false;
  bool done = false;

  template <typename Call>
  void tell(const Call& call) {
    if (fault) return;
    try {
      call();
    } catch (...) {
      fault = std::current_exception();
      XML_StopParser(expat, XML_FALSE);
    }
  }

  static Parser& of(void* data) { return *static_cast<Parser*>(data); }
  static void begin(void* data, const char* name, const char** attributes) {
    of(data).tell([&] { of(data).listener.begin(local(name), XmlAttributes(attributes)); });
  }
  static void end(void* data, const char* name) {
    of(data).tell([&] { of(data).listener.end(local(name)); });
  }
  static void text(void* data, const char* part, int size) {
    of(data).tell([&] { of(data).listener.text({part, static_cast<std::size_t>(size)}); });
  }
  static void type(void* data, const char* /*name*/, const char* /*system*/, const char* /*id*/,
                   int /*has_inner*/) {
    of(data).has_type = true;
    XML_StopParser(of(data).expat, XML_FALSE);
  }

  [[noreturn]] void fail() const {
    if (fault) std::rethrow_exception(fault);
    const std::string reason =
        has_type ? "it has a document type" : XML_ErrorString(XML_GetErrorCode(expat));
    throw Error(Message{file, 0, "is not whole, or no spreadsheet: " + reason, {}});
  }
};

XmlReader::XmlReader(const std::string& file, const std::string& name, XmlListener& listener)
    : parser_(new Parser{
          file, VsiBytes(file, name), listener, XML_ParserCreate(nullptr), {}, {}, false, false}) {
  if (parser_->expat == nullptr) throw std::bad_alloc();
  XML_SetUserData(parser_->expat, parser_.get());
  XML_SetElementHandler(parser_->expat, Parser::begin, Parser::end);
  XML_SetCharacterDataHandler(parser_->expat, Parser::text);
  XML_SetStartDoctypeDeclHandler(parser_->expat, Parser::type);
  parser_->buffer.resize(bytes_at_once);
}

XmlReader::~XmlReader() {
  XML_ParserFree(parser_->expat);
}

bool XmlReader::read_on() {
  Parser& it = *parser_;
  if (it.done) return false;
  const std::size_t count = it.bytes.read(it.buffer.data(), it.buffer.size());
  it.done = count == 0;
  if (XML_Parse(it.expat, it.buffer.data(), static_cast<int>(count), it.done ? 1 : 0) !=
      XML_STATUS_OK) {
    it.fail();
  }
  return !it.done;
}

}  // namespace thiessen
