#!/bin/sh
# Installs what is needed (Debian packages), builds everything and runs all tests. Arguments go to the configuration.
set -eu
cd "$(dirname "$0")/../.."

sh package_info/Frame_fields/install_debian_packages.sh g++ make cmake libcgal-dev libcgal-demo libeigen3-dev \
  libtbb-dev libboost-program-options-dev nlohmann-json3-dev libgtest-dev libbenchmark-dev libopenmesh-dev \
  libsuitesparse-dev zlib1g-dev doxygen python3 python3-gmsh python3-scipy parallel

cmake --preset release "$@"
cmake --build --preset release --parallel "$(nproc)"
ctest --preset release --parallel "$(nproc)"
