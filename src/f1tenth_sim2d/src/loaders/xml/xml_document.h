#pragma once

#include <tinyxml2.h>

#include <map>
#include <memory>
#include <string>

#include "loaders/xml/element.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// An XML text and where it came from.
struct XmlDocument : std::enable_shared_from_this<XmlDocument>
{
  tinyxml2::XMLDocument text;
  std::string file;         ///< what messages call it
  std::string folder;       ///< of the file, for paths beside it; empty for a text
  std::string included_by;  ///< "FILE: ELEMENT PATH" of the <include>; empty: not included
};

/// The documents of one world or robot description. Elements point into them; whoever keeps one keeps its document.
class XmlDocuments
{
public:
  /// @param warnings  must outlive this
  explicit XmlDocuments(WarningCollector & warnings) : warnings_(warnings) {}

  /// Root element of a file, which is read once however often it is asked for.
  /// @param asked_by  the <include>, or none
  /// @throws LoadError for a file that cannot be read or is not XML
  Element readFile(const std::string & path, const Element & asked_by = {});

  /// Root element of a text.
  /// @param source  what messages call it
  Element readText(const std::string & xml, const std::string & source);

private:
  Element read(XmlDocument & document, const std::string & xml);

  WarningCollector & warnings_;
  std::map<std::string, std::shared_ptr<XmlDocument>> documents_;
};
}  // namespace f1tenth_sim2d
