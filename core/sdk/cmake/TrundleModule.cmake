# SPDX-License-Identifier: BSD-2-Clause
# A module of controllers or components:
#
#   trundle_module(wall_follower FOLDER controllers SOURCES wall_follower.cpp)
#
# builds ${TRUNDLE_MODULE_DIR}/controllers/libwall_follower.so, which a text loads with `#loadModule controllers/wall_follower`,
# and libwall_follower.so.kinds.json next to it, from which checks and completion read its kinds without running its code.
#   FOLDER  subfolder of TRUNDLE_MODULE_DIR; default: that folder itself
#   OUTPUT  library name if it differs from the target's name
#   LINK    further libraries
# `cmake --install` copies both files if TRUNDLE_MODULE_INSTALL_DIR is set.

function(trundle_module name)
  cmake_parse_arguments(MOD "" "FOLDER;OUTPUT" "SOURCES;LINK" ${ARGN})
  if(NOT MOD_SOURCES)
    message(FATAL_ERROR "trundle_module(${name}): give SOURCES")
  endif()
  if(NOT MOD_OUTPUT)
    set(MOD_OUTPUT ${name})
  endif()
  if(NOT TRUNDLE_MODULE_DIR)
    set(TRUNDLE_MODULE_DIR ${CMAKE_BINARY_DIR})
  endif()
  set(target module_${name})
  set(library lib${MOD_OUTPUT}.so)

  add_library(${target} MODULE ${MOD_SOURCES})
  target_link_libraries(${target} PRIVATE trundle::sdk ${MOD_LINK})
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES
    PREFIX lib OUTPUT_NAME ${MOD_OUTPUT} LIBRARY_OUTPUT_DIRECTORY ${TRUNDLE_MODULE_DIR}/${MOD_FOLDER}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON)

  # Lines of functions, for the report of a crash.
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug,RelWithDebInfo>>:-g1>)

  # GCC counts a tab as eight columns otherwise, so that editors would show the wrong place.
  target_compile_options(${target} PRIVATE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,11>>:-fdiagnostics-column-unit=byte>)

  # GNU unique symbols would be shared between two modules, or two versions of one, and prevent unloading.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  # Undefined symbols are link errors here instead of load errors for the user. (A sanitizer's runtime is provided by the
  # program.)
  if(UNIX AND NOT APPLE AND NOT TRUNDLE_SANITIZE)
    target_link_options(${target} PRIVATE -Wl,-z,defs)
  endif()

  if(TARGET trundle-cli)
    set(describe $<TARGET_FILE:trundle-cli>)
    add_dependencies(${target} trundle-cli)
  else()
    set(describe ${TRUNDLE_CLI}) # for modules outside this source tree; empty: no description is written
  endif()
  if(describe)
    add_custom_command(TARGET ${target} POST_BUILD
      COMMAND ${describe} describe --module $<TARGET_FILE:${target}> --output $<TARGET_FILE:${target}>.kinds.json
      BYPRODUCTS ${TRUNDLE_MODULE_DIR}/${MOD_FOLDER}/${library}.kinds.json
      COMMENT "Describing ${MOD_OUTPUT}" VERBATIM)
  endif()
  if(TRUNDLE_MODULE_INSTALL_DIR)
    install(FILES $<TARGET_FILE:${target}> DESTINATION ${TRUNDLE_MODULE_INSTALL_DIR}/${MOD_FOLDER})
    if(describe)
      install(FILES $<TARGET_FILE:${target}>.kinds.json DESTINATION ${TRUNDLE_MODULE_INSTALL_DIR}/${MOD_FOLDER})
    endif()
  endif()
endfunction()
