#!/usr/bin/env bash
# Builds the Debian packages, with Debian's compiler flags and folders, and leaves them in build/package/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/setup.sh

install_packages

folder=build/package
# Release has its own -O; there are no debug symbols to keep. Paths of this folder are not written.
export DEB_BUILD_MAINT_OPTIONS=hardening=+bindnow DEB_CFLAGS_MAINT_STRIP=-g DEB_CXXFLAGS_MAINT_STRIP=-g
CFLAGS=$(dpkg-buildflags --get CFLAGS)
CXXFLAGS="$(dpkg-buildflags --get CXXFLAGS) $(dpkg-buildflags --get CPPFLAGS)"
LDFLAGS=$(dpkg-buildflags --get LDFLAGS)
export CFLAGS CXXFLAGS LDFLAGS

rm -f $folder/*.deb
configure_build $folder -DCMAKE_INSTALL_PREFIX=/usr -DPOSTURE_BUILD_TESTS=OFF -DPOSTURE_WARNINGS_AS_ERRORS=OFF
build_in $folder all
(cd $folder && cpack >/dev/null)
ls $folder/*.deb
