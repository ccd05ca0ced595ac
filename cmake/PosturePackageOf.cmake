# posture_package_of(<target>)
#
# The one table of what our modules take from elsewhere. Of a target that a module links to, it sets
# package_find      arguments of find_package() that give it to those who link to the module
# package_requires  its pkg-config package, or, where there is no usable one,
# package_cflags    compiler flags for those who see its headers through ours, and
# package_libs      linker flags
# package_debian    the Debian package that has all this
# Headers that only our own sources include need no line: they are wrapped in $<BUILD_INTERFACE:...>.
macro(posture_package_of target)
  foreach(what find requires cflags libs debian)
    set(package_${what})
  endforeach()
  if("${target}" STREQUAL "Eigen3::Eigen")
    set(package_find "Eigen3 3.4")
    set(package_requires "eigen3 >= 3.4")
    set(package_debian "libeigen3-dev (>= 3.4)")
  elseif("${target}" STREQUAL "OpenMP::OpenMP_CXX")
    set(package_find "OpenMP COMPONENTS CXX")
    set(package_cflags ${OpenMP_CXX_FLAGS})
    set(package_libs ${OpenMP_CXX_FLAGS})
  elseif("${target}" STREQUAL "Ceres::ceres")
    set(package_find "Ceres")
    set(package_libs -lceres)
    set(package_debian "libceres-dev")
  elseif("${target}" STREQUAL "liblzf::liblzf")
    set(package_find "liblzf")
    set(package_requires "liblzf")
    set(package_debian "liblzf-dev")
  elseif("${target}" MATCHES "^pcl_.+$" AND NOT TARGET ${target})
    # A library by its plain name, where PCL's component of that name brings VTK and Qt.
    set(package_libs -l${target})
    set(package_debian "libpcl-dev (>= 1.13)")
  elseif("${target}" MATCHES "^pcl_(.+)$")
    set(package_find "PCL 1.13 COMPONENTS ${CMAKE_MATCH_1}")
    # Not by PCL's pkg-config files: they bring FLANN's, and with it MPI.
    set(package_cflags -I${PCL_CONF_INCLUDE_DIR})
    posture_pcl_libraries(${target} package_libs)
    set(package_debian "libpcl-dev (>= 1.13)")
  elseif("${target}" STREQUAL CMAKE_DL_LIBS)
    set(package_libs -l${target})
  else()
    message(FATAL_ERROR "Where do those who link to us get ${target}? Say so in "
      "cmake/PosturePackageOf.cmake, or wrap it in $<BUILD_INTERFACE:...> if only our sources need its headers.")
  endif()
endmacro()

# The linker flags of a PCL component and of those it takes.
function(posture_pcl_libraries target flags)
  set(result)
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL INTERFACE_LIBRARY)
    set(result -l${target})
  endif()
  get_target_property(needed ${target} INTERFACE_LINK_LIBRARIES)
  foreach(other ${needed})
    if(other MATCHES "^pcl_" AND TARGET ${other})
      posture_pcl_libraries(${other} further)
      list(APPEND result ${further})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES result)
  set(${flags} ${result} PARENT_SCOPE)
endfunction()
