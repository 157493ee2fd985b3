"""What bench/python/run measures: frames from Python and from C++, in turn."""

import statistics
import subprocess
import sys
import time

import numpy as np
import refraster

WIDTH, HEIGHT = 1280, 720
MOST = 1.05


def main():
    program = sys.argv[1]
    frames = int(sys.argv[2]) if len(sys.argv) > 2 else 31
    failed = False
    print(f"{WIDTH}x{HEIGHT} pixels, medians of {frames}")
    print()
    print("| triangles | ms to render: C++, Python | Python / C++ | ms to make the mesh: C++, Python |")
    print("|---|---|---|---|")
    for segments in [int(word) for word in sys.argv[3:]] or [320, 640, 1280]:
        shape = refraster.sphere(segments=segments, rings=segments // 2)
        positions, normals, triangles = (np.array(each) for each in (shape.positions, shape.normals, shape.triangles))
        scene = refraster.Scene(
            camera=refraster.Camera(position=(0, 0, 3), target=(0, 0, 0), near=1, far=10),
            direction_lights=[refraster.DirectionLight(direction=(0, 0, -1))],
        )
        other = subprocess.Popen([program, str(segments), str(WIDTH), str(HEIGHT)], stdin=subprocess.PIPE,
                                 stdout=subprocess.PIPE, text=True, bufsize=1)
        made, rendered = {"C++": [], "Python": []}, {"C++": [], "Python": []}

        def from_cpp():
            other.stdin.write("\n")
            other.stdin.flush()
            make, render, shaded = other.stdout.readline().split()
            made["C++"].append(float(make)), rendered["C++"].append(float(render))
            return int(shaded)

        def from_python():
            begin = time.perf_counter()
            mesh = refraster.Mesh(positions, triangles, normals=normals)
            scene.objects = [refraster.Object(mesh)]
            middle = time.perf_counter()
            frame = scene.render(size=(WIDTH, HEIGHT))
            end = time.perf_counter()
            made["Python"].append(1e3 * (middle - begin)), rendered["Python"].append(1e3 * (end - middle))
            return frame.report["counts"]["pixels"]["shaded"]

        for repetition in range(frames + 1):
            # Neither always follows the other.
            shaded = {work() for work in ((from_cpp, from_python) if repetition % 2 else (from_python, from_cpp))}
            if len(shaded) != 1:
                sys.exit(f"not the same image: {shaded} pixels shaded")
        other.stdin.close()
        other.wait()
        median = {key: statistics.median(times[1:]) for key, times in rendered.items()}  # the first warms up
        make = {key: statistics.median(times[1:]) for key, times in made.items()}
        ratio = median["Python"] / median["C++"]
        print(f"| {len(triangles)} | {median['C++']:.1f}, {median['Python']:.1f} | {ratio:.3f} | "
              f"{make['C++']:.2f}, {make['Python']:.2f} |", flush=True)
        failed = failed or (len(triangles) > 100000 and ratio > MOST)
    sys.exit(f"more than {MOST} times as long as in C++" if failed else 0)


main()
