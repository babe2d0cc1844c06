#!/bin/sh
# Installs what is needed (Debian packages), builds the programs cad_frame_field and cad_quad_mesh, runs them on two CAD
# models and renders the fields and the quadrangles. Everything is written below build/.
set -eu
cd "$(dirname "$0")/../.."

sh package_info/Frame_fields/install_debian_packages.sh g++ make cmake libcgal-dev libcgal-demo libeigen3-dev \
  libtbb-dev libboost-program-options-dev nlohmann-json3-dev zlib1g-dev python3 python3-numpy python3-vtk9 xvfb xauth

cmake --preset release
cmake --build --preset release --target cad_frame_field cad_quad_mesh --parallel "$(nproc)"

output=build/release/example
mkdir -p "$output"
tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$output" data/meshes/mech-holes-shark.off

# Programs and pictures need no screen.
draw() { LIBGL_ALWAYS_SOFTWARE=1 xvfb-run --auto-servernum /usr/bin/python3 "$@"; }

field() # name title model [option...]
{
  name=$1 title=$2
  shift 2
  build/release/bin/cad_frame_field "$@" -o "$output/$name.ply" --vtp "$output/$name.vtp" --report "$output/$name.json"
  draw examples/Frame_fields/render_frame_field.py "$output/$name.vtp" "$output/$name.png" --title "$title" \
    --focus-sharpest
}

quads() # name model [option...]
{
  name=$1
  shift
  build/release/bin/cad_quad_mesh "$@" -o "$output/$name.vtp" -o "$output/$name.obj" -o "$output/$name.msh" \
    --report "$output/$name.json"
}

smoothest="--support none --no-repair --no-relaxation"
flange="examples/Frame_fields/data/flange.off --features examples/Frame_fields/data/flange.feat"
shark="$output/data/meshes/mech-holes-shark.off"

# shellcheck disable=SC2086 # one word an argument
{
  field flange "Flange: sharp corners get index 1/4" $flange
  field flange_baseline "Flange: the smoothest field, without correction" $flange $smoothest --no-baseline --quiet
  field mech-holes-shark "mech-holes-shark" "$shark"

  quads flange_quads $flange --quads 6000
  quads flange_baseline_quads $flange --quads 6000 $smoothest --quiet
  quads mech-holes-shark_quads "$shark" --quads 4000
  quads mech-holes-shark_baseline_quads "$shark" --quads 4000 $smoothest --quiet
}

beside() # name view...
{
  name=$1
  shift
  draw examples/Frame_fields/render_quad_mesh.py "$output/${name}_baseline_quads.vtp" "$output/${name}_quads.vtp" \
    "$output/${name}_quads.png" --beside --title "The smoothest field" --title "This package" "$@"
}

beside flange --view 30 40 --view 210 -30
beside mech-holes-shark --view 60 25 --view 240 -25

echo "Look at flange.png, flange_baseline.png, mech-holes-shark.png, flange_quads.png and mech-holes-shark_quads.png"
echo "in $output; the quadrangles are in files .vtp (ParaView), .obj and .msh (Gmsh) beside them."
