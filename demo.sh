#!/usr/bin/env bash
# Installs what is missing, builds the programs, registers a bundled pair of meshes with holes and
# leaves pictures, a report and figures in demo-output/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/setup.sh

install_packages
build posture posture-render

posture=build/release/apps/posture/posture
pair=quadruped-pose0-pose3
source_mesh=data/quadruped/quadruped-pose0.ply
target_mesh=data/quadruped/quadruped-pose3.ply

# Everything is made beside its place and moved there at the end, so that no half of a run stays.
out=build/demo
rm -rf "$out"

say "Registering $source_mesh to $target_mesh"
"$posture" register "$source_mesh" "$target_mesh" -o "$out" --quiet >/dev/null

say "Measuring the correspondence against the known one"
"$posture" evaluate "$out/correspondence.csv" --target "$target_mesh" -o "$out" \
  --truth "data/quadruped/$pair.txt" --mirror "data/quadruped/$pair-mirror.txt" \
  >"$out/evaluation.txt"

say "Drawing"
view=(--view left --view three-quarter --up z --same-scale --boundary --size 480x400)
"$posture" render "$out"/{source_colored,target_colored}.ply "${view[@]}" -o "$out/correspondence.png"
"$posture" render "$out/registered.ply" "$target_mesh" "${view[@]}" -o "$out/registered.png"

rm -rf demo-output
mv "$out" demo-output

figure() { awk -v name="$1" 'index($0, name) == 1 {print substr($0, 24)}' demo-output/evaluation.txt; }
sides="mistaken: a mirrored answer"
if [[ $(figure side) == right* ]]; then sides="told apart"; fi
cat <<END

A made-up four-legged body, standing and looking round; another mesh and six other holes each time.
No markers, no template, no starting alignment, no parameters.

  vertices with a counterpart   $(figure accepted)
  at most two edges off         $(figure 'within two edges') of those
  mean error                    $(figure 'mean error x100') % of the square root of the surface's area
  left and right                $sides

  demo-output/correspondence.png   source and target; what corresponds has one colour, grey has none
  demo-output/registered.png       the source, bent onto the target, beside the target
  demo-output/report.html          all figures; the files beside it are in docs/formats.md
END
