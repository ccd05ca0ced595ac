#!/usr/bin/env bash
# compare_launch.sh DATA OUT: compare.launch, run with the one method that takes no time, leaves its tables.
set -euo pipefail

data=$1 out=$2
rm -rf "$out"
mkdir -p "$out"
# A name that roslaunch's own arguments could be taken for.
cp "$data/human/human-pose0.ply" "$out/pose:=0.ply"
printf 'id,source,target\npair,pose:=0.ply,%s\n' "$data/human/human-pose6.ply" >"$out/list:=.csv"
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://127.0.0.1:$port
cat >"$out/nested.launch" <<LAUNCH
<launch>
  <include file="\$(find posture)/launch/compare.launch">
    <arg name="source" value="$out/list:=.csv"/>
    <arg name="folder" value="$out/results"/>
    <arg name="options" value="--method as-given --variation aligned"/>
  </include>
</launch>
LAUNCH
timeout 300 roslaunch -p "$port" "$out/nested.launch"
[[ -s $out/results/comparison.csv ]] || {
  echo "FAILED: no comparison.csv" >&2
  exit 1
}
grep -q '^pair,.*,as-given,' "$out/results/comparison.csv"
