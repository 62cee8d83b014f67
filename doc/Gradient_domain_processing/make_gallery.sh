#!/bin/sh
# Makes the pictures of the page "A Window, a Tutorial, a Gallery" with the commands that it shows.
#
#   make_gallery.sh BUILD
#
# BUILD is a folder with gradient_domain_filter and gradient_domain_viewer, configured with -DCGAL_GDP_WITH_VIEWER=ON.
# Debian: libcgal-demo for the meshes; xvfb and xauth where there is no screen. pngquant makes the pictures smaller.
set -eu
programs=$(cd "$1" && pwd)
figures=$(cd "$(dirname "$0")" && pwd)/fig
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
tar xzf /usr/share/doc/libcgal-demo/data.tar.gz --strip-components=2 \
  data/meshes/femur.off data/meshes/bunny00.off data/meshes/armadillo.off
export LIBGL_ALWAYS_SOFTWARE=1
screen() {
  if [ -n "${DISPLAY-}" ]; then "$@"; else xvfb-run -a -s "-screen 0 1280x1024x24" "$@"; fi
}
filter() { screen "$programs/gradient_domain_filter" "$@"; }

filter femur.off clean.ply --operation denoise --max-displacement 0.01 --picture gallery_denoise.png
filter bunny00.off sharp.ply --gradient-weight 2e-5 --gradient-scale 3 --picture gallery_sharpen.png
filter armadillo.off smooth.ply --gradient-weight 1e-3 --picture gallery_smooth.png
filter armadillo.off kept.ply --gradient-weight 1e-3 --metric edge-aware --picture gallery_edge_aware.png
filter armadillo.off detailed.ply --operation enhance-details --sharpening-scale 6 --picture gallery_enhance.png
filter armadillo.off waves.ply --operation band-stop --wavelengths 5,25 --picture gallery_bands.png

cat > viewer.script << 'END'
turn 25 15 0.8
set wavelength 0.06
set scale 3
set brush mask
set brush-size 0.12
drag 0.45 0.55 0.7 0.75
set colors displacement
screenshot viewer.png
END
screen "$programs/gradient_domain_viewer" bunny00.off --script viewer.script

if command -v pngquant > /dev/null; then
  pngquant --force --ext .png 64 gallery_*.png viewer.png
fi
cp gallery_*.png viewer.png "$figures"
