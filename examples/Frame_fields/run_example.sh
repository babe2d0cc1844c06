#!/bin/sh
# Installs what is needed (Debian packages), builds the program cad_frame_field, runs it on two CAD models and renders
# the results. Everything is written below build/.
set -eu
cd "$(dirname "$0")/../.."

sh package_info/Frame_fields/install_debian_packages.sh g++ make cmake libcgal-dev libcgal-demo libeigen3-dev \
  libtbb-dev libboost-program-options-dev nlohmann-json3-dev python3 python3-numpy python3-vtk9 xvfb xauth

cmake --preset release
cmake --build --preset release --target cad_frame_field --parallel "$(nproc)"

output=build/release/example
mkdir -p "$output"
tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$output" data/meshes/mech-holes-shark.off

render() # name title model [option...]
{
  name=$1 title=$2
  shift 2
  build/release/bin/cad_frame_field "$@" -o "$output/$name.ply" --vtp "$output/$name.vtp" --report "$output/$name.json"
  LIBGL_ALWAYS_SOFTWARE=1 xvfb-run --auto-servernum /usr/bin/python3 examples/Frame_fields/render_frame_field.py \
    "$output/$name.vtp" "$output/$name.png" --title "$title" --focus-sharpest
}

render flange "Flange: sharp corners get index 1/4" \
  examples/Frame_fields/data/flange.off --features examples/Frame_fields/data/flange.feat
render flange_baseline "Flange: the smoothest field, without correction" \
  examples/Frame_fields/data/flange.off --features examples/Frame_fields/data/flange.feat \
  --support none --no-repair --no-relaxation --no-baseline --quiet
render mech-holes-shark "mech-holes-shark" "$output/data/meshes/mech-holes-shark.off"

echo "Look at $output/flange.png, $output/flange_baseline.png and $output/mech-holes-shark.png"
