# posture_package_of(<target> <find> <requires> <cflags> <libs>)
#
# The one table of what our modules take from elsewhere. For a target that a module links to:
# <find>      arguments of find_package() that give the target to those who link to the module
# <requires>  its pkg-config package, or, where there is no usable one,
# <cflags>    compiler flags for those who see its headers through ours, and
# <libs>      linker flags
# Headers that only our own sources include need no line: they are wrapped in $<BUILD_INTERFACE:...>.
function(posture_package_of target find requires cflags libs)
  foreach(result ${find} ${requires} ${cflags} ${libs})
    set(${result} "" PARENT_SCOPE)
  endforeach()
  if(target STREQUAL "Eigen3::Eigen")
    set(${find} "Eigen3 3.4" PARENT_SCOPE)
    set(${requires} "eigen3 >= 3.4" PARENT_SCOPE)
  elseif(target STREQUAL "OpenMP::OpenMP_CXX")
    set(${find} "OpenMP COMPONENTS CXX" PARENT_SCOPE)
    set(${cflags} ${OpenMP_CXX_FLAGS} PARENT_SCOPE)
    set(${libs} ${OpenMP_CXX_FLAGS} PARENT_SCOPE)
  elseif(target STREQUAL "Ceres::ceres")
    set(${find} "Ceres" PARENT_SCOPE)
    set(${libs} -lceres PARENT_SCOPE)
  elseif(target STREQUAL "liblzf::liblzf")
    set(${find} "liblzf" PARENT_SCOPE)
    set(${requires} "liblzf" PARENT_SCOPE)
  elseif(target MATCHES "^pcl_(.+)$")
    set(${find} "PCL 1.13 COMPONENTS ${CMAKE_MATCH_1}" PARENT_SCOPE)
    # Not by PCL's pkg-config files: they bring FLANN's, and with it MPI.
    set(${cflags} -I${PCL_CONF_INCLUDE_DIR} PARENT_SCOPE)
    posture_pcl_libraries(${target} flags)
    set(${libs} ${flags} PARENT_SCOPE)
  elseif(target STREQUAL CMAKE_DL_LIBS)
    set(${libs} -l${target} PARENT_SCOPE)
  else()
    message(FATAL_ERROR "Where do those who link to us get ${target}? Say so in "
      "cmake/PosturePackageOf.cmake, or wrap it in $<BUILD_INTERFACE:...> if only our sources need its headers.")
  endif()
endfunction()

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
