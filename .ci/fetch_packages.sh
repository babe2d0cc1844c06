#!/bin/sh
# fetch_packages.sh FOLDER: unpacks CGAL, Eigen and AMGCL of later Debian suites, which are header-only, into FOLDER.
# They come from the mirror that this machine is configured for, past its own package lists. What is there is kept.
set -eu
mkdir -p "$1"
folder=$(cd "$1" && pwd)

# shellcheck source=/dev/null
. /etc/os-release
# shellcheck disable=SC2016 # apt fills in the URI
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Component: main' \
  "Release: $VERSION_CODENAME" | head -n 1)
[ -n "$mirror" ] || { echo "apt knows no mirror of $VERSION_CODENAME" >&2; exit 1; }

apt_get() {
  apt-get -qq -o Dir::Etc::SourceList="$folder/sources.list" -o Dir::Etc::SourceParts=- \
    -o Dir::State::Lists="$folder/lists" -o APT::Sandbox::User=root "$@"
}

# fetch NAME SUITE PACKAGE: unpacks the package of the suite into the folder NAME.
fetch() {
  [ ! -d "$folder/$1" ] || return 0
  rm -rf "$folder/download" "$folder/unpacked"
  mkdir -p "$folder/download" "$folder/lists/partial"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $2 main" > "$folder/sources.list"
  apt_get update --error-on=any
  (cd "$folder/download" && apt_get download "$3")
  dpkg -x "$folder/download/$3"_*.deb "$folder/unpacked"
  mv "$folder/unpacked" "$folder/$1"
}

fetch cgal-trixie trixie libcgal-dev
fetch cgal-sid sid libcgal-dev
fetch eigen-sid sid libeigen3-dev
fetch amgcl-sid sid libamgcl-dev
