#!/bin/sh
# fetch_packages.sh FOLDER: unpacks CGAL, Eigen and AMGCL of later Debian suites, which are header-only, into FOLDER.
# They come from the mirror that this machine is configured for, past its own package lists. What is there is kept.
# The viewer of CGAL is in a package of its own.
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

# fetch NAME SUITE PACKAGE...: unpacks the packages of the suite into the folder NAME, which lists them.
fetch() {
  name=$1 suite=$2
  shift 2
  [ "$(cat "$folder/$name/packages" 2> /dev/null)" != "$*" ] || return 0
  rm -rf "$folder/download" "$folder/unpacked"
  mkdir -p "$folder/download" "$folder/lists/partial"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" > "$folder/sources.list"
  apt_get update --error-on=any
  (cd "$folder/download" && apt_get download "$@")
  for package in "$folder"/download/*.deb; do
    dpkg -x "$package" "$folder/unpacked"
  done
  echo "$*" > "$folder/unpacked/packages"
  rm -rf "${folder:?}/$name"
  mv "$folder/unpacked" "$folder/$name"
}

fetch cgal-trixie trixie libcgal-dev libcgal-qt6-dev
fetch cgal-sid sid libcgal-dev libcgal-qt6-dev
fetch eigen-sid sid libeigen3-dev
fetch amgcl-sid sid libamgcl-dev
