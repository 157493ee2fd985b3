"""use_module.py PREFIX SCENE: the module that is installed below the prefix renders the scene."""

import sys

import refraster

prefix, scene = sys.argv[1:]
assert refraster.__file__.startswith(prefix), refraster.__file__
assert refraster.load(scene).render(size=(8, 6)).color.shape == (6, 8, 3)
