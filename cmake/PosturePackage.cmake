# Debian packages: scripts/package.sh. One for each install component, so that VTK comes with the
# pictures alone.
if(NOT PROJECT_IS_TOP_LEVEL OR NOT POSTURE_BUILD_RENDER)
  return()
endif()

set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME posture)
set(CPACK_PACKAGE_VENDOR "the posture authors")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
# Each component has its own.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL commands rendering development)
if(TARGET posture_node)
  list(APPEND CPACK_COMPONENTS_ALL ros)
endif()
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/complete.cmake)
# For that script: it sees variables named like this.
set(CPACK_POSTURE_SOURCE_DIR ${PROJECT_SOURCE_DIR})

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "the posture authors <posture@localhost>")
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_COMMANDS_PACKAGE_NAME posture)
set(CPACK_DEBIAN_COMMANDS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMMANDS_PACKAGE_RECOMMENDS posture-render)
set(CPACK_COMPONENT_COMMANDS_DESCRIPTION "registration of two scans of one bending body
Takes two scans of the same bending body in two poses, raw points or meshes,
and says for every point of one where it is on the other: no markers, no
template, no starting alignment.

This package has the command, its documents and small shapes to try it on.")

set(CPACK_DEBIAN_RENDERING_PACKAGE_NAME posture-render)
set(CPACK_DEBIAN_RENDERING_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RENDERING_PACKAGE_DEPENDS xvfb)
set(CPACK_COMPONENT_RENDERING_DESCRIPTION "pictures of meshes and point clouds, side by side
Draws meshes and point clouds into one picture, without a screen: the verb
\"posture render\".

Also brings what else of posture needs VTK: PCL's Poisson surface, one of the
ways to lay a surface through points.")

set(CPACK_DEBIAN_ROS_PACKAGE_NAME posture-ros)
set(CPACK_DEBIAN_ROS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_ROS_PACKAGE_DEPENDS "posture, python3-roslaunch")
set(CPACK_COMPONENT_ROS_DESCRIPTION "registration of bending bodies as a ROS node
Two point clouds in, by topics or files; the first bent onto the second, both
in corresponding colours, correspondences, near-rigid parts and diagnostics
out. With launch files for it and for the comparison with rigid methods.")

get_property(components GLOBAL PROPERTY POSTURE_COMPONENTS)
set(needed)
foreach(name ${components})
  get_property(packages GLOBAL PROPERTY POSTURE_${name}_DEBIAN)
  list(APPEND needed ${packages})
endforeach()
list(REMOVE_DUPLICATES needed)
list(JOIN needed ", " needed)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libposture-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ${needed})
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "posture, posture-render")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "registration of bending bodies: libraries and headers
Static libraries, one a stage of the registration of two scans of one bending
body, with what find_package() of CMake and pkg-config need.")

include(CPack)
