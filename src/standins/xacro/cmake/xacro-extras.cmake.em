@[if DEVELSPACE]@
set(_xacro_command "${PYTHON_EXECUTABLE}" "@(CMAKE_CURRENT_SOURCE_DIR)/scripts/xacro")
@[else]@
set(_xacro_command "${PYTHON_EXECUTABLE}" "${xacro_DIR}/../../../@(CATKIN_PACKAGE_BIN_DESTINATION)/xacro")
@[end if]@

# Expand INPUT when it or a file that it includes changes:
#   xacro_add_xacro_file(INPUT [OUTPUT_FILE] [INORDER] [REMAP a:=b ...] [OUTPUT variable] [DEPENDS target|file ...])
# OUTPUT_FILE defaults to INPUT without .xacro and is relative to the build folder; its absolute path is left in
# the variable (default XACRO_OUTPUT_FILE).
function(xacro_add_xacro_file input)
  cmake_parse_arguments(ARG "INORDER" "OUTPUT" "REMAP;DEPENDS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    list(GET ARG_UNPARSED_ARGUMENTS 0 output)
  else()
    string(REGEX REPLACE "\\.xacro$" "" output "${input}")
  endif()
  if(NOT ARG_OUTPUT)
    set(ARG_OUTPUT XACRO_OUTPUT_FILE)
  endif()
  get_filename_component(input "${input}" ABSOLUTE)
  get_filename_component(output "${output}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_BINARY_DIR}")
  get_filename_component(output_folder "${output}" DIRECTORY)
  file(MAKE_DIRECTORY "${output_folder}")

  execute_process(
    COMMAND ${CATKIN_ENV} ${_xacro_command} --deps "${input}" ${ARG_REMAP}
    RESULT_VARIABLE failed
    ERROR_VARIABLE reason
    OUTPUT_VARIABLE includes
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(failed)
    message(FATAL_ERROR "xacro cannot read ${input}: ${reason}")
  endif()
  separate_arguments(includes)
  # Which files are included may itself change with the input.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${input}")

  add_custom_command(
    OUTPUT "${output}"
    COMMAND ${CATKIN_ENV} ${_xacro_command} -o "${output}" "${input}" ${ARG_REMAP}
    DEPENDS "${input}" ${includes} ${ARG_DEPENDS}
    COMMENT "xacro ${output}"
    VERBATIM)
  set(${ARG_OUTPUT} "${output}" PARENT_SCOPE)
endfunction()

# Install what TARGET generates:
#   xacro_install(TARGET FILE ... [DESTINATION path below the package's share folder])
function(xacro_install target)
  cmake_parse_arguments(ARG "" "DESTINATION" "" ${ARGN})
  install(FILES ${ARG_UNPARSED_ARGUMENTS} DESTINATION "${CATKIN_PACKAGE_SHARE_DESTINATION}/${ARG_DESTINATION}")
endfunction()

# Expand several files as part of `all`:
#   xacro_add_files(INPUT ... [INORDER] [REMAP a:=b ...] [TARGET name] [INSTALL] [DESTINATION path]
#                   [OUTPUT variable] [DEPENDS target|file ...])
function(xacro_add_files)
  cmake_parse_arguments(ARG "INORDER;INSTALL" "TARGET;DESTINATION;OUTPUT" "REMAP;DEPENDS" ${ARGN})
  if(NOT ARG_TARGET)
    set(ARG_TARGET "${PROJECT_NAME}_xacro_generated_to_devel_space_")
  endif()
  set(outputs)
  foreach(input IN LISTS ARG_UNPARSED_ARGUMENTS)
    xacro_add_xacro_file("${input}" REMAP ${ARG_REMAP} DEPENDS ${ARG_DEPENDS} OUTPUT output)
    list(APPEND outputs "${output}")
  endforeach()
  add_custom_target(${ARG_TARGET} ALL DEPENDS ${outputs})
  if(ARG_INSTALL)
    xacro_install(${ARG_TARGET} ${outputs} DESTINATION "${ARG_DESTINATION}")
  endif()
  if(ARG_OUTPUT)
    set(${ARG_OUTPUT} "${outputs}" PARENT_SCOPE)
  endif()
endfunction()
