# Sets POSTURE_EIGEN_ALLOCATION to definitions of how Eigen allocates with this build's flags, which
# core/types.h compares with how it does in a program that uses the libraries.
function(posture_eigen_allocation)
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/eigen_allocation.cpp")
  file(WRITE "${source}" "#include <Eigen/Core>
posture EIGEN_MAX_ALIGN_BYTES EIGEN_MALLOC_ALREADY_ALIGNED\n")
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  separate_arguments(flags NATIVE_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}")
  execute_process(COMMAND "${CMAKE_CXX_COMPILER}" ${flags} -std=c++17 "-I${eigen}" -E -P "${source}"
    OUTPUT_VARIABLE preprocessed RESULT_VARIABLE failed)
  if(failed OR NOT preprocessed MATCHES "posture ([0-9]+) ([01])")
    message(FATAL_ERROR "How Eigen allocates could not be told: ${CMAKE_CXX_COMPILER} -E ${source}")
  endif()
  set(POSTURE_EIGEN_ALLOCATION POSTURE_EIGEN_MAX_ALIGN_BYTES=${CMAKE_MATCH_1}
    POSTURE_EIGEN_MALLOC_ALREADY_ALIGNED=${CMAKE_MATCH_2} PARENT_SCOPE)
endfunction()
