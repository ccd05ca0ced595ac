# ccache, where it is installed, makes rebuilding after a branch switch or a clean checkout cheap.
find_program(POSTURE_CCACHE ccache)
if(PROJECT_IS_TOP_LEVEL AND POSTURE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # What includes a precompiled header it keeps only when told to be lax about the time of that and the
  # macros it defines.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${POSTURE_CCACHE})
endif()
