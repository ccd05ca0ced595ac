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

# Notes for PostureInstall.cmake what those who link to a module need: the modules it takes, in
# global properties POSTURE_<name>_{MODULES,FIND,REQUIRES,REQUIRES_PRIVATE,CFLAGS,LIBS}, see
# posture_package_of().
function(posture_record_component name depends private_depends)
  set_property(GLOBAL APPEND PROPERTY POSTURE_COMPONENTS ${name})
  set(modules)
  foreach(dependency ${depends} ${private_depends})
    if(dependency MATCHES "^posture::(.+)$")
      get_property(further GLOBAL PROPERTY POSTURE_${CMAKE_MATCH_1}_MODULES)
      list(APPEND modules ${further})
    elseif(NOT dependency MATCHES "^\\$<BUILD_INTERFACE:")
      posture_package_of(${dependency} find requires cflags libs)
      set(kind REQUIRES)
      if(NOT dependency IN_LIST depends)
        set(kind REQUIRES_PRIVATE)
        set(cflags)
      endif()
      set_property(GLOBAL APPEND PROPERTY POSTURE_${name}_FIND ${find})
      set_property(GLOBAL APPEND PROPERTY POSTURE_${name}_${kind} ${requires})
      set_property(GLOBAL APPEND PROPERTY POSTURE_${name}_CFLAGS ${cflags})
      set_property(GLOBAL APPEND PROPERTY POSTURE_${name}_LIBS ${libs})
    endif()
  endforeach()
  list(APPEND modules ${name})
  list(REMOVE_DUPLICATES modules)
  set_property(GLOBAL PROPERTY POSTURE_${name}_MODULES ${modules})
endfunction()

# Warnings and language level of our own code; never handed on to those who link to us.
function(posture_target_settings target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  # Named although compilers have it by default: clang-tidy does not.
  set_target_properties(${target} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
    $<$<BOOL:${POSTURE_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()
