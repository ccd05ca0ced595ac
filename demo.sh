#!/usr/bin/env bash
# Installs what is missing, builds the programs, registers a bundled pair of raw scans and leaves
# pictures, a report and figures in demo-output/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/setup.sh

install_packages
build posture posture-render

posture=build/release/apps/posture/posture
scans=data/scans
pair=human-pose0-pose6-scan
source_scan=$scans/human-pose0-scan.pcd
target_scan=$scans/human-pose6-scan.pcd

# Everything is made beside its place and moved there at the end, so that no half of a run stays.
out=build/demo
rm -rf "$out"

say "Registering $source_scan to $target_scan"
"$posture" register "$source_scan" "$target_scan" -o "$out" --quiet >/dev/null

say "Measuring the correspondence against the known one"
"$posture" evaluate "$out/correspondence.csv" --target "$target_scan" -o "$out" \
  --surface "$scans/human-pose6.ply" --surface-vertices "$scans/human-pose6-scan-surface.txt" \
  --truth "$scans/$pair.txt" --mirror "$scans/$pair-mirror.txt" >"$out/evaluation.txt"

say "Drawing"
size=(--size 480x400)
"$posture" render "$source_scan" "$target_scan" "${size[@]}" -o "$out/scans.png"
"$posture" render "$out"/{source_colored,target_colored}.ply "${size[@]}" -o "$out/correspondence.png"
"$posture" render "$out"/{source_surface,registered_surface,target_surface}.ply --boundary \
  "${size[@]}" -o "$out/surfaces.png"

rm -rf demo-output
mv "$out" demo-output

figure() { awk -v name="$1" 'index($0, name) == 1 {print substr($0, 24)}' demo-output/evaluation.txt; }
sides="mistaken: a mirrored answer"
if [[ $(figure side) == right* ]]; then sides="told apart"; fi
cat <<END

Two raw scans of a made-up person, standing and with a knee raised: noisy points, holes, each in a
frame and unit of its own. No markers, no template, no starting alignment, no parameters.

  points with a counterpart     $(figure accepted)
  at most two edges off         $(figure 'within two edges') of those
  mean error                    $(figure 'mean error x100') % of the square root of the surface's area
  left and right                $sides

  demo-output/scans.png            the two scans as they came
  demo-output/correspondence.png   the same; what corresponds has one colour, grey has none
  demo-output/surfaces.png         the surface laid through the first, bent onto the second's, and that one
  demo-output/report.html          all figures; the files beside it are in docs/formats.md
END
