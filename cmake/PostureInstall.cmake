include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/posture)
configure_package_config_file(
  ${CMAKE_CURRENT_SOURCE_DIR}/cmake/postureConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/postureConfig.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(
  ${CMAKE_CURRENT_BINARY_DIR}/postureConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/postureConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/postureConfigVersion.cmake
  DESTINATION ${config_dir})
install(EXPORT postureTargets NAMESPACE posture:: DESTINATION ${config_dir})
