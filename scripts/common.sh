# What ./demo and ./check share. Sourced by them from the root of the clone; POSIX sh.

say() { printf '\n== %s\n' "$*"; }

# Packages of the named sections of packaging/apt-packages.txt.
packages_of() {
  for section in "$@"; do
    awk -v wanted="[$section]" '/^\[/ { on = ($0 == wanted) } on && /^[a-z0-9]/ { print $1 }' \
      packaging/apt-packages.txt
  done
}

# install_packages SECTION...: what is missing, with sudo only if we are not root.
install_packages() {
  # What an installed package provides is there, too: other builds of nodejs bring npm along.
  present=$(dpkg-query -W -f '${db:Status-Status}, ${Package}, ${Provides}\n' |
    sed -n 's/^installed, //p' | tr ', ' '\n\n')
  missing=
  for package in $(packages_of "$@"); do
    printf '%s\n' "$present" | grep -qxF "$package" || missing="$missing $package"
  done
  [ -z "$missing" ] && return 0
  say "Installing what is missing:$missing"
  sudo=
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      echo "These packages need root; run as root: apt-get install$missing" >&2
      return 1
    }
    sudo=sudo
  fi
  $sudo apt-get update -qq
  # shellcheck disable=SC2086  # a list of words
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing
}

# install_npm_packages FOLDER: exactly what its package-lock.json says, unless that is there.
install_npm_packages() {
  installed=$1/node_modules/.package-lock.json
  [ -f "$installed" ] && [ ! "$1/package-lock.json" -nt "$installed" ] && return 0
  say "Installing the npm packages of $1"
  npm ci --prefix "$1" --no-audit --no-fund
}

# build_view: the page that `ccmorse run` serves, into web/dist.
build_view() {
  install_npm_packages web
  npm run --silent --prefix web build
}

# build PRESET [cmake options]: configures once, then builds what has changed.
build() {
  preset=$1
  shift
  say "Building ($preset)"
  cmake --preset "$preset" "$@" >"build-$preset.log" 2>&1 || {
    cat "build-$preset.log" >&2
    rm -f "build-$preset.log"
    return 1
  }
  rm -f "build-$preset.log"
  cmake --build --preset "$preset"
}
