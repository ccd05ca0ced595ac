# What demo.sh and test.sh share: the Debian packages and the build. Sourced by bash from the
# repository's root.
# shellcheck shell=bash

# Debian 12. libpcl-dev brings VTK and Boost along; what our own CMake files ask for is named.
packages=(
  g++ cmake ninja-build ccache                                # build
  libeigen3-dev libboost-dev libpcl-dev liblzf-dev                    # modules
  libceres-dev libgoogle-glog-dev libspectra-dev nlohmann-json3-dev libcli11-dev
  libvtk9-dev libx11-dev libgl1-mesa-dri xvfb                 # pictures, with or without a screen
  libgtest-dev libgmock-dev pkg-config                        # tests
  dpkg-dev file                                               # Debian packages
  libroscpp-dev libstd-msgs-dev libgeometry-msgs-dev libsensor-msgs-dev       # the ROS node
  libvisualization-msgs-dev libdiagnostic-msgs-dev libstd-srvs-dev
  python3-roslaunch python3-rostest
)

say() { printf '%s\n' "$*" >&2; }

missing_packages() {
  local package
  for package in "${packages[@]}"; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
      printf '%s\n' "$package"
  done
}

# Asks apt only when something is missing.
install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "This is not Debian: nothing is installed; what is needed is listed in scripts/setup.sh."
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages)
  ((${#missing[@]})) || return 0
  local as_root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      say "Missing, and neither root nor sudo to install with: ${missing[*]}"
      return 1
    fi
    as_root=(sudo)
  fi
  say "Installing ${missing[*]}"
  local unattended=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive)
  local apt=("${unattended[@]}" apt-get -qq -o DPkg::Lock::Timeout=300)
  # What a killed run left half installed; dpkg cannot configure what lacks its dependencies, apt gets them.
  "${unattended[@]}" dpkg --configure -a >/dev/null 2>&1 || true
  "${apt[@]}" update
  "${apt[@]}" install -y --fix-broken --no-install-recommends "${missing[@]}" >/dev/null
}

# As many compilers as there are processors, but no more than memory can feed (1.5 GB each).
jobs_at_once() {
  local processors gigabytes
  processors=$(nproc)
  gigabytes=$(awk '/^MemAvailable:/ {print int($2 / 1500000)}' /proc/meminfo)
  local jobs=$((gigabytes < processors ? gigabytes : processors))
  printf '%s\n' "$((jobs > 0 ? jobs : 1))"
}

# configure_build FOLDER [OPTION...]: for a build in FOLDER, as the preset `release` says.
configure_build() {
  local folder=$1
  shift
  local generator=()
  if [[ ! -e $folder/CMakeCache.txt ]] && command -v ninja >/dev/null; then
    generator=(-G Ninja)
  fi
  cmake --preset release -B "$folder" "${generator[@]}" "$@" >/dev/null
}

# build_in FOLDER TARGET...: builds the targets and what they take. Goes on where an earlier build was
# stopped.
build_in() {
  local folder=$1
  shift
  local jobs
  jobs=$(jobs_at_once)
  say "Building in $folder, $jobs at a time"
  cmake --build "$folder" -j "$jobs" --target "$@"
}

# build TARGET...: in build/release.
build() {
  configure_build build/release
  build_in build/release "$@"
}
