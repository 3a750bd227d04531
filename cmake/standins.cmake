# Leave out each stand-in whose original is installed. A CATKIN_IGNORE file in its folder
# hides it from catkin and from rospack alike. Also runs as a script, for `catkin build`:
#   cmake -P cmake/standins.cmake

# All packages outside of own_source_dir, each as "NAME FOLDER": as rospack finds them, so that what is left out of the
# build is what roslaunch will find elsewhere. It looks in all folders of the ROS package path and of the prefixes,
# however deep.
function(find_packages own_source_dir result)
  string(REPLACE ":" ";" roots "$ENV{ROS_PACKAGE_PATH}")
  string(REPLACE ":" ";" prefixes "$ENV{CMAKE_PREFIX_PATH}")
  list(TRANSFORM prefixes APPEND /share)
  list(APPEND roots ${prefixes} /opt/ros/noetic/share /usr/share)
  list(FILTER roots EXCLUDE REGEX "^$")
  # The workspace itself comes last: of two packages of one name the first is found.
  foreach(root IN LISTS roots)
    string(FIND "${own_source_dir}/" "${root}/" in_root)
    string(FIND "${root}/" "${own_source_dir}/" in_sources)
    if(in_root EQUAL 0 OR in_sources EQUAL 0)
      list(REMOVE_ITEM roots "${root}")
      list(APPEND roots "${root}")
    endif()
  endforeach()
  list(JOIN roots ":" package_path)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -E env "ROS_PACKAGE_PATH=${package_path}" ROS_CACHE_TIMEOUT=0 rospack list
    OUTPUT_VARIABLE packages
    ERROR_VARIABLE error
    RESULT_VARIABLE failure)
  if(failure)
    message(WARNING "Stand-ins: whether their originals are installed is not known: ${failure} ${error}")
  endif()
  string(REPLACE "\n" ";" packages "${packages}")
  set(${result} "${packages}" PARENT_SCOPE)
endfunction()

# The folder of a package of this name among packages, unless it is a stand-in itself, as in an install space of this
# workspace or in another checkout.
function(find_original name packages own_source_dir result)
  set(${result} FALSE PARENT_SCOPE)
  foreach(package IN LISTS packages)
    if(package MATCHES "^${name} (.*)$")
      set(folder "${CMAKE_MATCH_1}")
      string(FIND "${folder}/" "${own_source_dir}/" position)
      file(STRINGS "${folder}/package.xml" standin REGEX "<description>Stand-in")
      if(NOT standin AND NOT position EQUAL 0)
        set(${result} "${folder}" PARENT_SCOPE)
      endif()
    endif()
  endforeach()
endfunction()

function(leave_out_standins folder)
  get_filename_component(source_dir "${folder}" DIRECTORY)
  find_packages("${source_dir}" packages)
  file(GLOB manifests "${folder}/*/package.xml")
  foreach(manifest IN LISTS manifests)
    get_filename_component(standin "${manifest}" DIRECTORY)
    get_filename_component(name "${standin}" NAME)
    find_original("${name}" "${packages}" "${source_dir}" original)
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
