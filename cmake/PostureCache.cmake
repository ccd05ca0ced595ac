# ccache, where it is installed, makes rebuilding after a branch switch or a clean checkout cheap.
find_program(POSTURE_CCACHE ccache)
if(PROJECT_IS_TOP_LEVEL AND POSTURE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${POSTURE_CCACHE})
endif()
