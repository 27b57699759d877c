#include "scene/urdf/parse_urdf.hpp"

#include <algorithm>
#include <stdexcept>

#include <console_bridge/console.h>
#include <tinyxml2.h>
#include <urdf_parser/urdf_parser.h>

#include "scene/files/xml_fault.hpp"
#include "scene/message_text.hpp"
#include "scene/urdf/drop_looks.hpp"

namespace rigid_body_sim {
namespace {

/// Keeps what urdfdom reports from the console while this lives.
class ParserMessages final : public console_bridge::OutputHandler {
 public:
  ParserMessages() : before_(console_bridge::getOutputHandler()) {
    console_bridge::useOutputHandler(this);
  }
  ~ParserMessages() override { console_bridge::useOutputHandler(before_); }
  ParserMessages(const ParserMessages&) = delete;
  ParserMessages& operator=(const ParserMessages&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* /*source_file*/,
           int /*source_line*/) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) errors_.push_back(text);
  }

  const std::vector<std::string>& errors() const { return errors_; }

 private:
  console_bridge::OutputHandler* before_;
  std::vector<std::string> errors_;
};

struct Parsed {
  urdf::ModelInterfaceSharedPtr model;
  std::vector<std::string> errors;  ///< the first is the cause of those behind it
};

/// urdfdom goes on after some errors, with zeros in place of what it could not read.
Parsed parsed(const tinyxml2::XMLDocument& document) {
  tinyxml2::XMLPrinter text(nullptr, true);
  document.Print(&text);
  const ParserMessages messages;
  Parsed result;
  try {
    result.model = urdf::parseURDF(text.CStr());
    result.errors = messages.errors();
  } catch (const std::exception& e) {
    result.errors = {e.what()};
  }
  if (!result.model && result.errors.empty()) result.errors = {"not the XML of a robot"};
  return result;
}

}  // namespace

ParsedUrdf parseUrdf(const std::string& xml) {
  const std::string fault = xmlFault(xml);
  if (!fault.empty()) throw std::runtime_error(fault);
  tinyxml2::XMLDocument document;
  if (document.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS)
    throw std::runtime_error("line " + std::to_string(document.ErrorLineNum()) +
                             " is not well-formed XML");
  ParsedUrdf urdf;
  urdf.notices = dropBadMaterials(document);
  Parsed whole = parsed(document);
  if (whole.errors.empty()) {
    urdf.model = whole.model;
    return urdf;
  }
  // what remains wrong without anything to draw is wrong with the robot itself
  dropVisuals(document);
  const Parsed bare = parsed(document);
  if (!bare.errors.empty()) throw std::runtime_error(bare.errors.front());
  urdf.model = whole.model ? whole.model : bare.model;
  urdf.looks_fault = nameList(whole.errors);
  urdf.notices.push_back("left out of what is drawn: " + urdf.looks_fault);
  return urdf;
}

}  // namespace rigid_body_sim
