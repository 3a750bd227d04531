# Leave out each stand-in whose original is installed. A CATKIN_IGNORE file in its folder
# hides it from catkin and from rospack alike. Also runs as a script, for `catkin build`:
#   cmake -P cmake/standins.cmake

# Whether a package of this name is installed outside this workspace: package.xml on the
# ROS package path or under a prefix of CMAKE_PREFIX_PATH, build and devel spaces left aside.
function(find_original name own_source_dir result)
  set(roots /usr/share /opt/ros/noetic/share)
  string(REPLACE ":" ";" prefixes "$ENV{CMAKE_PREFIX_PATH}")
  foreach(prefix IN LISTS prefixes)
    list(APPEND roots "${prefix}/share")
  endforeach()
  string(REPLACE ":" ";" package_path "$ENV{ROS_PACKAGE_PATH}")
  foreach(path IN LISTS package_path)
    string(FIND "${path}/" "${own_source_dir}/" position)
    if(NOT position EQUAL 0)
      list(APPEND roots "${path}")
    endif()
  endforeach()
  set(${result} FALSE PARENT_SCOPE)
  foreach(root IN LISTS roots)
    # A devel space of this very workspace has a share/NAME without package.xml.
    if(EXISTS "${root}/${name}/package.xml")
      set(${result} "${root}/${name}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

function(leave_out_standins folder)
  get_filename_component(source_dir "${folder}" DIRECTORY)
  file(GLOB manifests "${folder}/*/package.xml")
  foreach(manifest IN LISTS manifests)
    get_filename_component(standin "${manifest}" DIRECTORY)
    get_filename_component(name "${standin}" NAME)
    find_original("${name}" "${source_dir}" original)
    if(original)
      message(STATUS "Stand-in ${name}: left out, the original is at ${original}")
      file(WRITE "${standin}/CATKIN_IGNORE" "The original is installed: ${original}\n")
    else()
      file(REMOVE "${standin}/CATKIN_IGNORE")
    endif()
  endforeach()
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}" DIRECTORY)
  leave_out_standins("${root}/src/standins")
endif()
