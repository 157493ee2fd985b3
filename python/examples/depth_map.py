#!/usr/bin/env python3
"""From a model to a plotted depth map and a verdict: depth_map.py MODEL.obj|SCENE.json [FIGURE.png]"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import refraster

scene = refraster.load(sys.argv[1])
frame = scene.render(size=(480, 360), precision="float", aovs=["distance", "alpha"])
verdict = refraster.verify(scene, frame.rgb8)
distance = frame["distance"].copy()
distance[frame["alpha"] == 0] = float("nan")  # no surface: no distance
figure, axes = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
axes[0].imshow(frame.rgb8)
axes[0].set_title(f"{'passes' if verdict['passes'] else 'fails'}: {verdict['pixels']['exact']} of "
                  f"{verdict['pixels']['all']} pixels exact")
figure.colorbar(axes[1].imshow(distance, cmap="viridis_r"), label="distance from the camera, units of the scene")
for each in axes:
    each.set_axis_off()
figure.savefig(sys.argv[2] if len(sys.argv) > 2 else "depth_map.png")
print("passes" if verdict["passes"] else "fails")
