# Shared by every package of the workspace.

# C++17 and all warnings; CMAKE_COMPILE_WARNING_AS_ERROR makes them errors, as CI does.
# -ffp-contract=off: a fused multiply-add rounds once where two operations round twice, and whether
# the compiler fuses depends on the target; without it the same source gives the same bits everywhere.
# WORKSPACE_UNITY: eight files per translation unit. The headers of ROS and of the libraries cost more than our own
# lines, so a fresh build takes a third of the processor time, and one changed line still recompiles a thousand lines,
# not five thousand.
function(workspace_target target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources source_count)
  if(WORKSPACE_UNITY AND source_count GREATER 1)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    # The compiler treats the files of one unit as headers, where an anonymous namespace would be a mistake.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off)
  if(WORKSPACE_SANITIZE)
    _workspace_sanitize(${target})
  elseif(WORKSPACE_COVERAGE)
    target_compile_options(${target} PRIVATE --coverage -fprofile-update=atomic)
    target_link_options(${target} PRIVATE --coverage)
  endif()
endfunction()

# WORKSPACE_SANITIZE=address: AddressSanitizer and UBSan; thread: ThreadSanitizer.
function(_workspace_sanitize target)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all)
  if(WORKSPACE_SANITIZE STREQUAL "thread")
    set(sanitizers -fsanitize=thread)
  endif()
  target_compile_options(${target} PRIVATE ${sanitizers} -fno-omit-frame-pointer -O1 -g1
    -Wno-error) # the code that is inserted causes warnings of its own
  target_link_options(${target} PRIVATE ${sanitizers})
endfunction()

# A pybind11 module of this package, importable as NAME from the devel and the install space; with PACKAGE as
# PACKAGE._NAME, part of a Python package:
#   workspace_python_module(NAME [PACKAGE package] source.cpp ...)
# Needs find_package(pybind11) after set(PYBIND11_FINDPYTHON OFF) and the package's own library linked to it.
function(workspace_python_module name)
  cmake_parse_arguments(module "" "PACKAGE" "" ${ARGN})
  # The extras are link-time optimization, which gains nothing in a single unit and warns that it is slow.
  pybind11_add_module(${name} MODULE NO_EXTRAS ${module_UNPARSED_ARGUMENTS})
  workspace_target(${name})
  set(folder ${CATKIN_GLOBAL_PYTHON_DESTINATION})
  if(module_PACKAGE)
    set(folder ${folder}/${module_PACKAGE})
    set_target_properties(${name} PROPERTIES OUTPUT_NAME _${name})
  endif()
  set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${folder})
  install(TARGETS ${name} LIBRARY DESTINATION ${folder} COMPONENT python)
endfunction()

# The entry points of this package's Python modules, by which commands and other packages find them: a file of the form
# that https://packaging.python.org/specifications/entry-points describes.
function(workspace_entry_points file)
  set(folder ${CATKIN_GLOBAL_PYTHON_DESTINATION}/${PROJECT_NAME}.dist-info)
  set(made ${CATKIN_DEVEL_PREFIX}/${folder})
  file(WRITE ${made}/METADATA "Metadata-Version: 2.1\nName: ${PROJECT_NAME}\nVersion: ${${PROJECT_NAME}_VERSION}\n")
  configure_file(${file} ${made}/entry_points.txt COPYONLY)
  install(DIRECTORY ${made} DESTINATION ${CATKIN_GLOBAL_PYTHON_DESTINATION})
endfunction()

# Run pytest over the files matching PATTERNS, as one test target with a JUnit file; a second one in a package needs a
# NAME:
#   workspace_add_pytest()                                 all of test/ and its folders
#   workspace_add_pytest(EXCLUDE /slow/)                   all but those whose path matches
#   workspace_add_pytest(NAME slow test/slow/test_*.py)
function(workspace_add_pytest)
  cmake_parse_arguments(pytest "" "NAME;EXCLUDE" "" ${ARGN})
  set(patterns ${pytest_UNPARSED_ARGUMENTS})
  if(NOT patterns)
    set(patterns test/test_*.py test/*/test_*.py)
  endif()
  file(GLOB files CONFIGURE_DEPENDS ${patterns})
  if(pytest_EXCLUDE)
    list(FILTER files EXCLUDE REGEX "${pytest_EXCLUDE}")
  endif()
  if(NOT files)
    message(FATAL_ERROR "${PROJECT_NAME}: no file of tests matches ${patterns}")
  endif()
  set(paths)
  foreach(file IN LISTS files)
    list(APPEND paths "'${file}'") # a shell reads them, and a path may contain blanks
  endforeach()
  string(REPLACE ";" " " path_arguments "${paths}")
  set(name ${PROJECT_NAME})
  if(pytest_NAME)
    string(APPEND name "-${pytest_NAME}")
  endif()
  set(junit "${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/pytest-${name}.xml")
  catkin_run_tests_target("pytest" "${name}" "pytest-${name}.xml"
    COMMAND "${PYTHON_EXECUTABLE} -m pytest -q -p no:cacheprovider --junitxml='${junit}' ${path_arguments}"
    DEPENDENCIES ${${PROJECT_NAME}_EXPORTED_TARGETS})
endfunction()
