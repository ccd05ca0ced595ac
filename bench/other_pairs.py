#!/usr/bin/env python3
"""Writes a list of pairs the benchmark does not name, of bodies it has: poses of cats and horses,
which share their numbering, and pairs whose truth follows from that of two listed pairs. Of each
family twelve, spread evenly over all in the order of their names, so that none is picked.

    bench/other_pairs.py BENCHMARK_FOLDER OUT_FOLDER
    posture benchmark OUT_FOLDER/other.csv -o RESULTS
"""
import csv
import os
import sys

from benchmark_files import FAMILIES, read_truth

EACH = 12


def turned_round(truth):
    back = {}
    for source, target in sorted(truth.items()):
        back.setdefault(target, source)
    return back


def all_of(family, rows, benchmark):
    """(source, target) -> truth, None for one numbering; without those listed."""
    listed = {(r["source"], r["target"]): r["truth"] for r in rows if r["family"] == family}
    if set(listed.values()) == {"identity"}:
        meshes = sorted({mesh for pair in listed for mesh in pair})
        return {(a, b): None for a in meshes for b in meshes if a != b and (a, b) not in listed}
    known = {}
    for (a, b), truth in listed.items():
        known[a, b] = dict(read_truth(benchmark, truth))
        known.setdefault((b, a), turned_round(known[a, b]))
    found = {pair: truth for pair, truth in known.items() if pair not in listed}
    for (a, b), first in sorted(known.items()):
        for (c, d), second in sorted(known.items()):
            if b == c and a != d and (a, d) not in known and (a, d) not in found:
                found[a, d] = {v: second[w] for v, w in first.items() if w in second}
    return found


def main(benchmark, out):
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(benchmark, "pairs.csv")) as pairs:
        rows = list(csv.DictReader(pairs))
    with open(os.path.join(out, "other.csv"), "w", newline="") as listed:
        table = csv.DictWriter(listed, list(rows[0].keys()))
        table.writeheader()
        for family in FAMILIES:
            found = sorted(all_of(family, rows, benchmark).items())
            count = min(EACH, len(found))
            for (source, target), truth in (found[k * len(found) // count] for k in range(count)):
                names = [os.path.splitext(os.path.basename(p))[0] for p in (source, target)]
                row = {"id": "-to-".join(names), "family": "other-" + family, "kind": "isometric",
                       "source": os.path.abspath(os.path.join(benchmark, source)),
                       "target": os.path.abspath(os.path.join(benchmark, target)),
                       "truth": "identity"}
                if truth is not None:
                    row["truth"] = os.path.abspath(os.path.join(out, row["id"] + ".txt"))
                    with open(row["truth"], "w") as lines:
                        lines.writelines("%d %d\n" % pair for pair in sorted(truth.items()))
                table.writerow(row)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
