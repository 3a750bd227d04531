#include "loaders/files/package_path.h"

#include <tinyxml2.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <filesystem>

#include "loaders/files/files.h"

namespace f1tenth_sim2d
{
namespace
{
namespace fs = std::filesystem;

constexpr int kDepthMax = 12;  // a loop of symbolic links ends here

std::vector<fs::path> foldersIn(const fs::path & folder)
{
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && entry->path().filename().string().front() != '.') {
      found.push_back(entry->path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

void appendExported(const tinyxml2::XMLElement & package, const std::string & folder, std::vector<std::string> & found)
{
  const tinyxml2::XMLElement * const exports = package.FirstChildElement("export");
  for (auto tag = exports ? exports->FirstChildElement("gazebo_ros") : nullptr; tag;
       tag = tag->NextSiblingElement("gazebo_ros")) {
    for (const char * const attribute : {"gazebo_model_path", "gazebo_media_path"}) {
      const char * const value = tag->Attribute(attribute);
      for (const std::string & path : splitPathList(value ? value : "")) {
        found.push_back(boost::algorithm::replace_all_copy(path, "${prefix}", folder));
      }
    }
  }
}
}  // namespace

PackagePath::PackagePath(const std::vector<std::string> & folders)
{
  for (const std::string & folder : folders) {
    crawl(folder, 0);
  }
}

std::string PackagePath::folderOf(const std::string & package) const
{
  const auto found = folder_of_.find(package);
  return found == folder_of_.end() ? "" : found->second;
}

void PackagePath::crawl(const std::string & folder, int depth)
{
  const fs::path path(folder);
  if (depth > kDepthMax || isFile(path / "CATKIN_IGNORE") || isFile(path / "rospack_nosubdirs")) {
    return;
  }
  if (isFile(path / "package.xml")) {
    addPackage(folder);
    return;
  }
  for (const fs::path & inner : foldersIn(path)) {
    crawl(inner.string(), depth + 1);
  }
}

void PackagePath::addPackage(const std::string & folder)
{
  tinyxml2::XMLDocument document;
  if (document.LoadFile((fs::path(folder) / "package.xml").c_str()) != tinyxml2::XML_SUCCESS) {
    return;
  }
  const tinyxml2::XMLElement * const package = document.FirstChildElement("package");
  const tinyxml2::XMLElement * const name = package ? package->FirstChildElement("name") : nullptr;
  if (
    !name || !name->GetText() ||
    !folder_of_.try_emplace(boost::trim_copy(std::string(name->GetText())), folder).second) {
    return;
  }
  appendExported(*package, folder, model_folders_);
  model_folders_.push_back((fs::path(folder) / "models").string());
}
}  // namespace f1tenth_sim2d
