#!/usr/bin/env python3
"""What a frame costs in each precision, and how far it is from the truth: cost_and_error.py SCENE [FIGURE.png]"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import refraster

report = refraster.bench(sys.argv[1], size=(320, 180), threads=1, frames=5, seconds=1, marginals=False)
figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
for result in report["results"]:
    at = result["frame_ms"]["median"], result["error"]["against_exact"]["max_relative"]
    axes.semilogy(*at, "o", label=result["precision"])
axes.set_xlim(0)
axes.legend(title="precision")
axes.set_xlabel("a frame of 320 x 180 pixels by one thread, ms")
axes.set_ylabel("largest relative error against 60 digits")
axes.grid(True, which="both", alpha=0.3)
figure.savefig(sys.argv[2] if len(sys.argv) > 2 else "cost_and_error.png")
