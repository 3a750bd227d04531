#include "loaders/xml/xml_document.h"

#include <filesystem>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/files.h"
#include "loaders/xml/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
std::string errorOf(const tinyxml2::XMLDocument & document)
{
  static const std::string prefix = "XML_ERROR_";
  const std::string name = document.ErrorName();
  // "Error=XML_ERROR_MISMATCHED_ELEMENT ErrorID=14 (0xe) Line number=3: XMLElement name=link"
  const std::string details = document.ErrorStr();
  const std::size_t colon = details.find(": ");
  return "malformed XML: " + (name.rfind(prefix, 0) == 0 ? name.substr(prefix.size()) : name) +
         (colon == std::string::npos ? "" : ", " + details.substr(colon + 2));
}

std::string placeOf(const tinyxml2::XMLDocument & document)
{
  return document.ErrorLineNum() > 0 ? "line " + std::to_string(document.ErrorLineNum()) : "";
}
}  // namespace

Element XmlDocuments::readFile(const std::string & path, const Element & asked_by)
{
  std::shared_ptr<XmlDocument> & document = documents_[path];
  if (!document) {
    document = std::make_shared<XmlDocument>();
    document->file = path;
    document->folder = std::filesystem::path(path).parent_path().string();
    document->included_by = asked_by ? asked_by.place() : "";
    return read(*document, f1tenth_sim2d::readFile(path));
  }
  return {document->text.RootElement(), document.get()};
}

Element XmlDocuments::readText(const std::string & xml, const std::string & source)
{
  std::shared_ptr<XmlDocument> & document = documents_["text " + std::to_string(documents_.size())];
  document = std::make_shared<XmlDocument>();
  document->file = source;
  return read(*document, xml);
}

Element XmlDocuments::read(XmlDocument & document, const std::string & xml)
{
  tinyxml2::XMLDocument & text = document.text;
  if (text.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS) {
    const std::string error = errorOf(text);
    const std::string place = placeOf(text);
    if (text.Parse(repairedXml(xml).c_str()) != tinyxml2::XML_SUCCESS) {
      throw LoadError(
        document.file, place, error + (document.included_by.empty() ? "" : "; included by " + document.included_by));
    }
    warnings_.add(error + ": read as Gazebo does", document.file + (place.empty() ? "" : ": " + place));
  }
  if (!text.RootElement()) {
    throw LoadError(document.file, "", "holds no XML element");
  }
  return {text.RootElement(), &document};
}
}  // namespace f1tenth_sim2d
