#!/usr/bin/env bash
# check.sh CASE: checks of an installed tree. Paths come from the environment, see CMakeLists.txt.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$WORK/tree

fail() {
  printf 'FAILED: %s\n' "$*" >&2
  exit 1
}

# without_windows PROGRAM: nothing of VTK or Qt is loaded with it, and nothing is missing.
without_windows() {
  local libraries
  libraries=$(ldd "$1")
  if grep -iE 'libvtk|libQt|not found' <<<"$libraries"; then
    fail "$1 is linked with that"
  fi
}

check_tree() {
  rm -rf "$WORK/first" "$tree"
  "$CMAKE" --install "$BUILD" --prefix "$WORK/first" >/dev/null
  mv "$WORK/first" "$tree"
  diff <(cd "$SOURCE/modules" && find */include -name '*.h*' | sed 's#^[^/]*/##' | sort) \
    <(cd "$tree" && find include -name '*.h*' | sort) ||
    fail "the installed headers (>) are not those of the modules (<)"
  # Debug information names the sources.
  local files=(-r)
  if [[ $BUILD_TYPE != Release ]]; then files=(-rI); fi
  if grep "${files[@]}" -lF -e "$SOURCE" -e "$BUILD" "$tree"; then
    fail "these files name the folder they were built in"
  fi
  for file in share/doc/posture/LICENSE share/doc/posture/README.md share/posture/human/pairs.csv; do
    [[ -s $tree/$file ]] || fail "$file is missing"
  done
  check_links "$tree/share/doc/posture"
}

# check_links FOLDER: documents in it name none that is not there; those that name the sources, which
# are not installed, do so by their folders.
check_links() {
  local document link
  while IFS=: read -r document link; do
    [[ $link =~ ^(\.\./)?(modules|cmake|scripts)/ ]] && continue
    [[ -e $(dirname "$document")/$link ]] || fail "$document names $link, which is not installed"
  done < <(grep -rHoP --include='*.md' '\]\((?!https?:)\K[^)#]+' "$1")
}

check_commands() {
  local scan=$tree/share/posture/scans/human-pose0-scan.pcd
  without_windows "$tree/bin/posture"
  "$tree/bin/posture" reconstruct "$scan" --surface poisson -o "$WORK/poisson.ply" --quiet >/dev/null
  if [[ $RENDER == 1 ]]; then
    "$tree/bin/posture" render "$WORK/poisson.ply" -o "$WORK/poisson.png" --size 64x64
    [[ -s $WORK/poisson.png ]] || fail "no picture was drawn"
  fi
}

# options_of COMMAND...: what its --help lists.
options_of() { "$@" --help | grep -oE -- '^  [^ ]*--[a-z,-]+' | grep -oE -- '--[a-z-]+' | sort; }

# explained_in PAGE SECTION: the options that have an entry there.
explained_in() {
  awk -v section="$2" '/^\.S[SH] / { inside = $0 == section } inside && entry; { entry = $0 == ".TP" }' "$1" |
    tr -d '\\' | grep -oE -- '--[a-z-]+' | sort
}

# The verbs and options of --help are those the manual explains.
check_manual() {
  local manual=$tree/share/man/man1 verbs verb
  verbs=$("$tree/bin/posture" --help | sed -n '/^Subcommands/,$ s/^  \([a-z]\+\) .*/\1/p')
  diff <(sort <<<"$verbs") \
    <(sed -n '/^\.SH VERBS/,/^\.SH OPTIONS/ s/^\.SS //p' "$manual/posture.1" | sort) ||
    fail "the verbs (<) are not those of posture.1 (>)"
  diff <(options_of "$tree/bin/posture") <(explained_in "$manual/posture.1" ".SH OPTIONS") ||
    fail "the options (<) are not those of posture.1 (>)"
  for verb in $verbs; do
    [[ $verb == render ]] && continue # another program, whose manual is below
    diff <(options_of "$tree/bin/posture" "$verb" | grep -vx -- --help) \
      <(explained_in "$manual/posture.1" ".SS $verb") ||
      fail "the options of $verb (<) are not those of posture.1 (>)"
  done
  if [[ $RENDER == 1 ]]; then
    diff <(options_of "$tree/bin/posture-render") \
      <(explained_in "$manual/posture-render.1" ".SH OPTIONS") ||
      fail "the options (<) are not those of posture-render.1 (>)"
  fi
}

# configure PROJECT [OPTION...]: a project of its own that finds the tree.
configure() {
  local project=$1
  shift
  "$CMAKE" -S "$here/$project" -B "$WORK/$project" -DCMAKE_PREFIX_PATH="$tree" \
    -DCMAKE_BUILD_TYPE=Release "$@"
}

check_components() {
  rm -rf "$WORK/components"
  configure components >"$WORK/components.log" 2>&1 || fail "$(cat "$WORK/components.log")"
}

check_consumer() {
  rm -rf "$WORK/consumer"
  configure consumer >/dev/null
  "$CMAKE" --build "$WORK/consumer"
  without_windows "$WORK/consumer/register"
  without_windows "$WORK/consumer/everything"
  "$WORK/consumer/register" "$tree/share/posture"
}

# The examples as they are installed; one has PCL's interface in it.
check_examples() {
  rm -rf "$WORK/examples"
  "$CMAKE" -S "$tree/share/doc/posture/examples" -B "$WORK/examples" -DCMAKE_PREFIX_PATH="$tree" \
    -DCMAKE_BUILD_TYPE=Release >/dev/null
  "$CMAKE" --build "$WORK/examples"
  "$CTEST" --test-dir "$WORK/examples" --output-on-failure -R 02_pcl_registration --no-tests=error
}

check_pkg_config() {
  local flags
  export PKG_CONFIG_PATH
  PKG_CONFIG_PATH=$(dirname "$(find "$tree" -name posture.pc)")
  flags=$(pkg-config --cflags --libs --static posture)
  # shellcheck disable=SC2086  # these are lists of words
  "$CXX" $CXXFLAGS $LDFLAGS -O1 "$here/consumer/register.cpp" -o "$WORK/register" $flags
  without_windows "$WORK/register"
  "$WORK/register" "$tree/share/posture"
}

# has NAME PATH...: the package NAME has these files.
has() {
  local name=$1 path content
  shift
  content=$(dpkg-deb -c "$WORK/package/${name}"_*.deb)
  for path in "$@"; do
    grep -q " \./usr/$path\$" <<<"$content" || fail "$path is not in the package $name"
  done
}

# depends NAME PACKAGE...: the package NAME depends on these.
depends() {
  local name=$1 package list
  shift
  list=$(dpkg-deb -f "$WORK/package/${name}"_*.deb Depends)
  for package in "$@"; do
    grep -qF " $package" <<<" $list" || fail "$name does not depend on $package, but on $list"
  done
}

# depends_not NAME PATTERN: nor on anything like that.
depends_not() {
  if dpkg-deb -f "$WORK/package/${1}"_*.deb Depends | grep -iE "$2"; then
    fail "$1 depends on that"
  fi
}

check_package() {
  rm -rf "$WORK/package"
  "$CPACK" --config "$BUILD/CPackConfig.cmake" -B "$WORK/package" >"$WORK/package.log" 2>&1 ||
    fail "$(cat "$WORK/package.log")"
  has posture bin/posture share/man/man1/posture.1.gz share/doc/posture/copyright \
    share/posture/human/pairs.csv
  has posture-render bin/posture-render '.*/posture/libposture_poisson.so' \
    share/man/man1/posture-render.1.gz share/doc/posture-render/copyright
  has libposture-dev include/posture/core/types.h '.*/libposture_pipeline.a' \
    '.*/cmake/posture/postureConfig.cmake' '.*/pkgconfig/posture.pc' share/doc/libposture-dev/copyright
  if [[ $ROS == 1 ]]; then
    has posture-ros lib/posture/posture_node share/posture/launch/register.launch \
      share/posture/package.xml share/posture/posture_command share/doc/posture-ros/copyright
  fi
  depends posture libpcl-common libc6
  depends posture-render libvtk xvfb
  depends libposture-dev 'libpcl-dev (>= 1.13)' libceres-dev 'libeigen3-dev (>= 3.4)' liblzf-dev
  depends_not posture 'vtk|qt'
  depends_not libposture-dev 'vtk|qt'
  if [[ $ROS == 1 ]]; then
    depends posture-ros posture python3-roslaunch libroscpp libpcl-common
    depends_not posture-ros 'vtk|qt'
  fi
  run_unpacked
  if command -v lintian >/dev/null; then
    # The maintainers have no address that mail is sent to.
    lintian --fail-on error --allow-root --suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog \
      "$WORK/package"/*.deb
  fi
}

# What the packages have works without anything else of this build.
run_unpacked() {
  local root=$WORK/package/root package program
  mkdir "$root"
  for package in "$WORK/package"/*.deb; do
    dpkg-deb -x "$package" "$root"
  done
  program=$root/usr/bin/posture
  [[ $("$program" --version) == "$VERSION" ]] || fail "the packaged posture is not version $VERSION"
  for surface in delaunay poisson; do
    "$program" reconstruct "$root/usr/share/posture/scans/human-pose0-scan.pcd" --surface $surface \
      -o "$WORK/package/$surface.ply" --quiet >/dev/null
    [[ -s $WORK/package/$surface.ply ]] || fail "the packaged posture wrote no $surface surface"
  done
}

mkdir -p "$WORK"
"check_$1"
