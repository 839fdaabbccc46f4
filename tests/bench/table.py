#!/usr/bin/env python3
"""Prints ratios of one run of tests/bench/run.sh: medians of CPU time over its rounds."""
import json
import pathlib
import statistics
import sys


def cpu_name():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "unknown processor"


ROWS, UNKNOWN = 1400, 9  # of the benchmarks
PRESETS = ("accurate", "balanced", "fast")
CLOSED_FORMS = ("joint", "local")
FLOPS = ROWS * (ROWS + 1)  # per quadratic form
# Instruction sets of the kernels (core/learn/kernels/kernel_targets.h), fastest first. Other processors have "baseline"
# alone.
SETS = ("AVX-512", "AVX2", "SSE4")

UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def measured(path):
    """Returns name → CPU seconds; flops per second for peaks and products, seconds per chain-sweep for sweeps."""
    rows = [row for row in json.loads(path.read_text())["benchmarks"] if row.get("aggregate_name", "median") == "median"]
    return {row["run_name"]: row.get("flops", row.get("s_per_chain_sweep",
                                                  row["cpu_time"] * UNITS[row["time_unit"]]))
            for row in rows}


def products_left(path):
    """Returns the share of the products with all rows that a sweep in single precision computes."""
    return next(row["products_left"] for row in json.loads(path.read_text())["benchmarks"]
                if row["name"].startswith("sweep/") and "/f32/" in row["name"] and "products_left" in row)


def medians(rounds):
    return {name: statistics.median(r[name] for r in rounds)
            for name in rounds[0] if not isinstance(rounds[0][name], str)}


def main(folder):
    ours = medians([measured(p) for p in sorted(folder.glob("ours-*.json"))])
    ours |= measured(folder / "scenes.json")
    files = [json.loads(p.read_text()) for p in sorted(folder.glob("numpy-*.json"))]
    numpy = medians(files)
    sets = [s for s in SETS if f"peak/{s}/f32" in ours] or ["baseline"]
    best = sets[0]
    rows = []

    def row(what, target, reached, digits=2):
        shown = "" if target is None else f"{target:.{digits}f}"
        rows.append((what, shown, f"{reached:.{digits}f}"))

    def sweep(kernels, precision, chains):
        return ours[f"sweep/{kernels}/{precision}/{chains}"]

    row("chain-sweep, 16 chains: batched NumPy / ours", 4.0, numpy["sweep/16"] / sweep(best, "f32", 16))
    row("chain-sweep, 16 chains: single-chain NumPy / ours", 20.0, numpy["sweep/1"] / sweep(best, "f32", 16))
    row("chain-sweep, 64 chains: batched NumPy / ours", 3.5, numpy["sweep/64"] / sweep(best, "f32", 64))
    row("  the same, NumPy in float32", None, numpy["sweep/64/f32"] / sweep(best, "f32", 64))
    row("  the same, ours in double, through all rows", None, numpy["sweep/64"] / sweep(best, "f64", 64))
    row("chain-sweep, 16 chains: NumPy in float32 / ours", None, numpy["sweep/16/f32"] / sweep(best, "f32", 16))
    row("chain-sweep, 16 chains: batched NumPy / ours in double, through all rows", None,
        numpy["sweep/16"] / sweep(best, "f64", 16))
    row("one scene, K = 1000: NumPy with 16 chains / ours", 10.0, numpy["oneScene"] / ours["oneScene/f32"])
    row("  the same, ours in double, through all rows", None, numpy["oneScene"] / ours["oneScene/f64"])
    row("one scene, K = 1000: NumPy with one chain, 1050 sweeps / ours", 10.0,
        1050 * numpy["sweep/1"] / ours["oneScene/f32"])
    slowest = max(seconds for name, seconds in ours.items()
                  if name.startswith("oneBalancedScene/") and name.split("/")[1] not in CLOSED_FORMS)
    row("one scene, K = 1000: NumPy with 16 chains / ours at `balanced`, the slowest method", 10.0,
        numpy["oneScene"] / slowest)
    for name, seconds in ours.items():
        if name.startswith("oneBalancedScene/"):
            method = name.split("/")[1]
            row(f"one scene at `balanced`, K = 1000, {method} [ms]", 2 if method in CLOSED_FORMS else 33, seconds * 1e3, 1)
    row("likelihood and gradient: ours / NumPy", 0.6, ours["likelihoodAndGradient"] / numpy["likelihoodAndGradient"])
    for chains in (16, 64):
        if "AVX2" in sets and best == "AVX-512":
            row(f"chain-sweep, {chains} chains: AVX2's speed / AVX-512's", 0.6,
                sweep(best, "f32", chains) / sweep("AVX2", "f32", chains))
    if held := [json.loads(p.read_text()) for p in sorted(folder.glob("avx2-*.json"))]:
        row("chain-sweep, 64 chains: batched NumPy held to AVX2 / our AVX2 kernels (0.6 of 3.5)", 0.6 * 3.5,
            medians(held)["sweep/64"] / sweep("AVX2", "f32", 64))
    for kernels in sets:
        for precision in ("f32", "f64"):
            peak = ours[f"peak/{kernels}/{precision}"]
            for columns in (16, 64):
                row(f"quadratic form, {columns} columns, {kernels} {precision}: share of {peak * 1e-9:.0f} GF/s",
                    0.65 if columns == 64 else None, ours[f"quadratic/{kernels}/{precision}/{columns}"] / peak)
    per_draw = {name: seconds for name, seconds in ours.items() if name.startswith("draws")}
    slowest = max(per_draw, key=per_draw.get)
    row(f"truncated normal, slowest of {len(per_draw)} regimes ({slowest.split('/')[1]}) [ns a draw]", 150, per_draw[slowest] * 1e9, 0)

    print(f"{cpu_name()}; one thread; NumPy {files[0]['numpy']} on OpenBLAS's kernels for {files[0]['kernels']}; "
          f"medians of {len(files)} rounds, CPU time")
    width = max(len(r[0]) for r in rows)
    for what, target, reached in [("", "target", "reached"), *rows]:
        print(f"{what:<{width}}  {target:>7}  {reached:>7}")
    print("\nms per chain-sweep" + "".join(f"{f'{c} chains':>12}" for c in (1, 8, 16, 64)))
    for kernels in sets:
        for precision in ("f32", "f64"):
            print(f"{kernels + ' ' + precision:<18}" +
                  "".join(f"{sweep(kernels, precision, c) * 1e3:12.3f}" for c in (1, 8, 16, 64)))
    print(f"{'NumPy float64':<18}{numpy['sweep/1'] * 1e3:12.3f}{'':12}{numpy['sweep/16'] * 1e3:12.3f}{numpy['sweep/64'] * 1e3:12.3f}")
    print("\nscenes of an evaluation,\nms per chain-sweep       one after the other   batched   ratio")
    for what in ("1 chains", "4 chains", "8 chains", "16 chains", "700 rows", "300 rows", "175 rows", *PRESETS):
        alone, batched = (ours[f"scenes/{what}/{how}"] * 1e3 for how in ("alone", "batched"))
        print(f"{what:<24}{alone:20.4f}{batched:10.4f}{alone / batched:8.2f}")

    left = products_left(sorted(folder.glob("ours-*.json"))[0])
    print(f"\nwhere a chain-sweep in single precision goes, ms; {left:.2f} of the products with all rows are left"
          f"\n{'':<22}{'all':>8}{'quadratic form':>16}{'at the peak':>13}{'covariances':>13}{'draws':>8}{'rest':>8}")
    draws = UNKNOWN * statistics.mean(seconds for name, seconds in per_draw.items() if name.startswith("drawsBelow/"))
    flops = left * UNKNOWN * FLOPS
    for kernels in sets:
        peak = ours[f"peak/{kernels}/f32"]
        covariances = UNKNOWN * ours[f"covariances/{kernels}"] / 8
        for chains in (16, 64):
            quadratic = flops / ours[f"quadratic/{kernels}/f32/{chains}"]
            parts = [sweep(kernels, "f32", chains), quadratic, flops / peak, covariances, draws]
            parts.append(parts[0] - quadratic - covariances - draws)
            print(f"{f'{kernels}, {chains} chains':<22}" + "".join(
                f"{1e3 * seconds:{width}.4f}" for seconds, width in zip(parts, (8, 16, 13, 13, 8, 8))))

    print()
    limits = [("NumPy at 64 chains: share of the peak in double, as full products",
               UNKNOWN * 2 * ROWS * ROWS / numpy["sweep/64"] / ours[f"peak/{best}/f64"])]
    if "AVX2" in sets and best == "AVX-512":
        limits.append(("FMA peak in single precision: AVX2 / AVX-512", ours["peak/AVX2/f32"] / ours[f"peak/{best}/f32"]))
    for what, value in limits:
        print(f"{what:<84}{value:8.2f}")
    print(f"\nms per scene of 16 chains, K = 1000: {ours['oneScene/f32'] * 1e3:.0f} (f32), "
          f"{ours['oneScene/f64'] * 1e3:.0f} (f64), clearances {ours['oneClearanceScene'] * 1e3:.0f}")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
