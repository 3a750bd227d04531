#pragma once

#include <map>
#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// The ROS packages below some folders, found as rospack finds them: a folder with a package.xml is a package and is
/// not searched further, the first of two with the same name counts, CATKIN_IGNORE and hidden folders are skipped.
///
/// Not librospack: it pulls in the Python interpreter and writes a cache into the home folder.
class PackagePath
{
public:
  explicit PackagePath(const std::vector<std::string> & folders);

  /// Folder of a package; empty if there is none of this name.
  std::string folderOf(const std::string & package) const;

  /// Folders of models and resources that packages name, <export><gazebo_ros gazebo_model_path="${prefix}/models"
  /// gazebo_media_path="${prefix}"/></export>, and the folder `models` of each package.
  const std::vector<std::string> & modelFolders() const { return model_folders_; }

private:
  void crawl(const std::string & folder, int depth);
  void addPackage(const std::string & folder);

  std::map<std::string, std::string> folder_of_;
  std::vector<std::string> model_folders_;
};
}  // namespace f1tenth_sim2d
