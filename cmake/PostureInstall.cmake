# What find_package(posture) and pkg-config read, and what is neither program nor library. Each file
# belongs to one of the install components commands, rendering, ros and development; the Debian
# packages are these four.
include(CMakePackageConfigHelpers)

get_property(POSTURE_COMPONENTS GLOBAL PROPERTY POSTURE_COMPONENTS)
set(kinds REQUIRES REQUIRES_PRIVATE CFLAGS LIBS)
set(POSTURE_COMPONENT_TABLE)
set(POSTURE_PC_ARCHIVES)
foreach(name ${POSTURE_COMPONENTS})
  get_property(modules GLOBAL PROPERTY POSTURE_${name}_MODULES)
  get_property(packages GLOBAL PROPERTY POSTURE_${name}_FIND)
  # All PCL components in one call.
  set(pcl ${packages})
  list(FILTER pcl INCLUDE REGEX "^PCL ")
  list(FILTER packages EXCLUDE REGEX "^PCL ")
  if(pcl)
    list(TRANSFORM pcl REPLACE "^.*COMPONENTS " "")
    list(JOIN pcl " " pcl)
    list(APPEND packages "PCL 1.13 COMPONENTS ${pcl}")
  endif()
  list(JOIN modules " " modules)
  list(TRANSFORM packages REPLACE "(.+)" " \"\\1\"")
  list(JOIN packages "" packages)
  string(APPEND POSTURE_COMPONENT_TABLE
    "set(_posture_${name}_modules ${modules})\nset(_posture_${name}_packages${packages})\n")

  foreach(kind ${kinds})
    get_property(values GLOBAL PROPERTY POSTURE_${name}_${kind})
    list(APPEND POSTURE_PC_${kind} ${values})
  endforeach()
  # A module uses those before it; the linker wants users first.
  get_target_property(type posture_${name} TYPE)
  if(NOT type STREQUAL INTERFACE_LIBRARY)
    string(PREPEND POSTURE_PC_ARCHIVES "-lposture_${name} ")
  endif()
endforeach()
get_target_property(definitions posture_core INTERFACE_COMPILE_DEFINITIONS)
list(TRANSFORM definitions PREPEND -D)
list(PREPEND POSTURE_PC_CFLAGS ${definitions})
foreach(kind ${kinds})
  list(REMOVE_DUPLICATES POSTURE_PC_${kind})
  list(JOIN POSTURE_PC_${kind} " " POSTURE_PC_${kind})
endforeach()

configure_package_config_file(
  ${CMAKE_CURRENT_SOURCE_DIR}/cmake/postureConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/postureConfig.cmake
  INSTALL_DESTINATION ${POSTURE_CONFIG_DIR})
write_basic_package_version_file(
  ${CMAKE_CURRENT_BINARY_DIR}/postureConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/postureConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/postureConfigVersion.cmake
  DESTINATION ${POSTURE_CONFIG_DIR} COMPONENT development)

# From the file to the prefix: the tree may be moved.
file(RELATIVE_PATH POSTURE_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" POSTURE_PC_PREFIX ${POSTURE_PC_PREFIX})
configure_file(cmake/posture.pc.in posture.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/posture.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

if(POSTURE_BUILD_APPS)
  install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT commands)
  install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT commands)
  # What they name lies about them as it does in the sources.
  foreach(folder bench bench/tables examples launch)
    file(GLOB documents ${folder}/*.md ${folder}/*.svg)
    install(FILES ${documents} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder} COMPONENT commands)
  endforeach()
  set(data_dir ${CMAKE_INSTALL_DATADIR}/posture)
  install(DIRECTORY data/ DESTINATION ${data_dir} COMPONENT commands)
  file(RELATIVE_PATH data_from_documents /${CMAKE_INSTALL_DOCDIR} /${data_dir})
  install(CODE "file(CREATE_LINK ${data_from_documents}
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DOCDIR}/data\" SYMBOLIC)" COMPONENT commands)
endif()
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development
  PATTERN *.md EXCLUDE)
