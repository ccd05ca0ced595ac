# posture_add_module(<name> SOURCES <file>... [DEPENDS <target>...] [PRIVATE_DEPENDS <target>...])
#
# The library target posture_<name> (alias posture::<name>), its headers in include/posture/<name>.
function(posture_add_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(target posture_${name})
  add_library(${target} ${ARG_SOURCES})
  add_library(posture::${name} ALIAS ${target})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
  posture_target_settings(${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  install(TARGETS ${target} EXPORT postureTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY include/posture DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# Warnings and language level of our own code; never handed on to those who link to us.
function(posture_target_settings target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  # Named although compilers have it by default: clang-tidy does not.
  set_target_properties(${target} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
    $<$<BOOL:${POSTURE_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()
