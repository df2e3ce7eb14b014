"""Makes the rows `cornell` and `cornell balls` of block_means.csv with Mitsuba 3.

    python3 -m venv /tmp/mitsuba && /tmp/mitsuba/bin/pip install mitsuba==3.9.1 numpy
    /tmp/mitsuba/bin/python tests/published/cornell.py > rows.csv

The box is that of Cornell University's data, in millimetres here and in metres in the scene; paints and lamp are the linear RGB
values of `src/scene/cornell.rs`. The lamp hangs half a millimetre below the ceiling, shines downwards and reflects nothing.
"""

import sys

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb" if "llvm_ad_rgb" in mi.variants() else "scalar_rgb")

SAMPLES, SEED, SIZE, BLOCK = 4096, 1, 200, 25
WHITE, RED, GREEN = [0.738, 0.736, 0.740], [0.490, 0.050, 0.051], [0.069, 0.398, 0.087]
LAMP = [20.66, 10.90, 2.766]

FLOOR = [[552.8, 0, 0], [0, 0, 0], [0, 0, 559.2], [549.6, 0, 559.2]]
CEILING = [[556, 548.8, 0], [556, 548.8, 559.2], [0, 548.8, 559.2], [0, 548.8, 0]]
BACK = [[549.6, 0, 559.2], [0, 0, 559.2], [0, 548.8, 559.2], [556, 548.8, 559.2]]
RIGHT = [[0, 0, 559.2], [0, 0, 0], [0, 548.8, 0], [0, 548.8, 559.2]]
LEFT = [[552.8, 0, 0], [549.6, 0, 559.2], [556, 548.8, 559.2], [556, 548.8, 0]]
SHORT = (165, [[130, 65], [82, 225], [240, 272], [290, 114]])
TALL = (330, [[423, 247], [265, 296], [314, 456], [472, 406]])
LAMP_CORNERS = [[213, 548.3, 227], [343, 548.3, 227], [343, 548.3, 332], [213, 548.3, 332]]


def paint(colour):
    """A matte paint that is seen from both sides."""
    matte = {"type": "diffuse", "reflectance": {"type": "rgb", "value": colour}}
    return {"type": "twosided", "bsdf": matte}


def quad(corners, bsdf, emitter=None):
    """Two triangles, by four corners in millimetres."""
    properties = mi.Properties()
    properties["bsdf"] = mi.load_dict(bsdf)
    if emitter:
        properties["emitter"] = mi.load_dict(emitter)
    mesh = mi.Mesh("quad", 4, 2, props=properties)
    parameters = mi.traverse(mesh)
    parameters["vertex_positions"] = (np.array(corners, dtype=np.float32) / 1000).ravel()
    parameters["faces"] = np.array([0, 1, 2, 0, 2, 3], dtype=np.uint32)
    parameters.update()
    return mesh


def block(height, corners):
    """The top and the four sides of a block."""
    at = lambda y, i: [corners[i % 4][0], y, corners[i % 4][1]]
    sides = [[at(0, i), at(height, i), at(height, i + 1), at(0, i + 1)] for i in range(4)]
    return [[at(height, i) for i in range(4)], *sides]


def room(walls):
    """Painted walls, the lamp and the camera."""
    scene = {"type": "scene", "integrator": {"type": "path", "max_depth": 64}}
    for i, (corners, colour) in enumerate(walls):
        scene[f"wall{i}"] = quad(corners, paint(colour))
    black = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.0}}
    shines = {"type": "area", "radiance": {"type": "rgb", "value": LAMP}}
    scene["lamp"] = quad(LAMP_CORNERS, black, shines)
    scene["camera"] = {
        "type": "perspective",
        "fov": float(2 * np.degrees(np.arctan(25 / 2 / 35))),
        "to_world": mi.ScalarTransform4f().look_at([0.278, 0.273, -0.8], [0.278, 0.273, 0], [0, 1, 0]),
        "film": {
            "type": "hdrfilm",
            "width": SIZE,
            "height": SIZE,
            "pixel_format": "rgb",
            "rfilter": {"type": "box"},
        },
    }
    return scene


def box():
    """The measured box with its two blocks."""
    white = [FLOOR, CEILING, BACK, *block(*SHORT), *block(*TALL)]
    return room([(corners, WHITE) for corners in white] + [(RIGHT, GREEN), (LEFT, RED)])


def box_with_balls():
    """A room with right angles, a mirror ball and a glass ball."""
    x, y, z = 556, 548.8, 560
    level = lambda h: [[0, h, 0], [x, h, 0], [x, h, z], [0, h, z]]
    side = lambda s: [[s, 0, 0], [s, y, 0], [s, y, z], [s, 0, z]]
    back = [[0, 0, z], [x, 0, z], [x, y, z], [0, y, z]]
    scene = room([(level(0), WHITE), (level(y), WHITE), (back, WHITE), (side(0), GREEN), (side(x), RED)])
    mirror = {"type": "conductor", "material": "none", "specular_reflectance": {"type": "rgb", "value": 0.95}}
    glass = {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0}
    scene["mirror"] = {"type": "sphere", "center": [0.40, 0.1, 0.38], "radius": 0.1, "bsdf": mirror}
    scene["glass"] = {"type": "sphere", "center": [0.16, 0.1, 0.20], "radius": 0.1, "bsdf": glass}
    return scene


def rows(name, scene):
    """The means of the picture's blocks and their standard errors, by the passes: a row for each block."""
    scene = mi.load_dict(scene)
    passes, blocks = 16, SIZE // BLOCK
    pictures = [np.array(mi.render(scene, spp=SAMPLES // passes, seed=SEED + i)) for i in range(passes)]
    means = np.array(pictures, dtype=np.float64).reshape(passes, blocks, BLOCK, blocks, BLOCK, 3).mean(axis=(2, 4))
    numbers = np.concatenate([means.mean(axis=0), means.std(axis=0, ddof=1) / np.sqrt(passes)], axis=-1)
    for row in range(blocks):
        for column in range(blocks):
            print(f"{name},{row},{column}," + ",".join(f"{v:.5f}" for v in numbers[row, column]))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        SAMPLES = int(sys.argv[1])
    rows("cornell", box())
    rows("cornell balls", box_with_balls())
