include(PosturePackageOf)

# posture_add_module(<name> [SOURCES <file>...] [DEPENDS <target>...] [PRIVATE_DEPENDS <target>...])
#
# The library target posture_<name> (alias posture::<name>), its headers in include/posture/<name>,
# and the component <name> of find_package(posture). Without sources: headers alone.
function(posture_add_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(target posture_${name})
  set(scope PUBLIC)
  if(ARG_SOURCES)
    add_library(${target} ${ARG_SOURCES})
    target_link_libraries(${target} PRIVATE ${ARG_PRIVATE_DEPENDS})
    posture_target_settings(${target})
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  else()
    add_library(${target} INTERFACE)
    target_compile_features(${target} INTERFACE cxx_std_17)
    set(scope INTERFACE)
  endif()
  add_library(posture::${name} ALIAS ${target})
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} ${scope} ${ARG_DEPENDS})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})

  install(TARGETS ${target} EXPORT posture-${name}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT posture-${name} NAMESPACE posture::
    DESTINATION ${POSTURE_CONFIG_DIR} COMPONENT development)
  install(DIRECTORY include/posture DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  posture_record_component(${name} "${ARG_DEPENDS}" "${ARG_PRIVATE_DEPENDS}")
endfunction()

# Notes for PostureInstall.cmake, in global properties POSTURE_<name>_<what>, what those who link to a
# module need: the MODULES it takes, itself last, and what posture_package_of() says of the rest.
function(posture_record_component name depends private_depends)
  set_property(GLOBAL APPEND PROPERTY POSTURE_COMPONENTS ${name})
  set(modules)
  foreach(dependency ${depends} ${private_depends})
    if(dependency MATCHES "^posture::(.+)$")
      get_property(further GLOBAL PROPERTY POSTURE_${CMAKE_MATCH_1}_MODULES)
      list(APPEND modules ${further})
    elseif(NOT dependency MATCHES "^\\$<BUILD_INTERFACE:")
      posture_package_of(${dependency})
      set(requires_kind REQUIRES)
      if(NOT dependency IN_LIST depends)
        set(requires_kind REQUIRES_PRIVATE)
        set(package_cflags)
      endif()
      set_property(GLOBAL APPEND PROPERTY POSTURE_${name}_FIND ${package_find})
      set_property(GLOBAL APPEND PROPERTY POSTURE_${name}_${requires_kind} ${package_requires})
      set_property(GLOBAL APPEND PROPERTY POSTURE_${name}_CFLAGS ${package_cflags})
      set_property(GLOBAL APPEND PROPERTY POSTURE_${name}_LIBS ${package_libs})
      set_property(GLOBAL APPEND PROPERTY POSTURE_${name}_DEBIAN ${package_debian})
    endif()
  endforeach()
  list(APPEND modules ${name})
  list(REMOVE_DUPLICATES modules)
  set_property(GLOBAL PROPERTY POSTURE_${name}_MODULES ${modules})
endfunction()

# Warnings, language level and the names of files in messages, for our own code; never handed on to
# those who link to us.
function(posture_target_settings target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  # Named although compilers have it by default: clang-tidy does not.
  set_target_properties(${target} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
    $<$<BOOL:${POSTURE_WARNINGS_AS_ERRORS}>:-Werror>
    # Macros such as ROS's write __FILE__ into the binary; what is installed names no folder it was built in.
    -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/= -fmacro-prefix-map=${PROJECT_BINARY_DIR}/=)
endfunction()
