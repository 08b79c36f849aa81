"""Which metric of a scene is its error, and what a stranger is told about the scene. Data only.

A scene's `sources` are names of the suite's cases: errors of several are averaged, and so are costs. An error is
the magnitude of the metric. Below `floor` an error is a matter of rounding (floats of a scene of 10 m are 1e-6 m
apart), above `ceiling` nothing is left of the scene: such points are drawn in a strip of their own. A stack whose top
came down by `fallen_m` has fallen, as in the suite; so has a crowd of which somebody left the pit. A scene with `arguments` is no
numbered case: it is run by itself, with these arguments of the suite's program.
"""
import math
from collections import namedtuple

Scene = namedtuple("Scene", "name title caption axis metric floor ceiling fallen_m sources arguments")

BULLET_SPEEDS = (10, 30, 60, 120, 240, 390)


def scene(name, title, caption, axis, metric, floor=1e-6, ceiling=100.0, fallen_m=math.inf, sources=None, arguments=()):
    return Scene(name, title, caption, axis, metric, floor, ceiling, fallen_m, tuple(sources or (name,)), tuple(arguments))


def free(spin):
    return scene(f"1_free_w{spin}", f"Thrown box, spinning at {spin} rad/s",
                 "A box is thrown and flies for 10 s; the error is how far it gets from the exact parabola.",
                 "distance from the parabola (m)", "pos_err_m", 1e-5)


def chain(way, ratio):
    what = {"hang": "hangs", "swing": "is let go level and swings"}[way]
    title = {"hang": "Hanging chain", "swing": "Swinging chain"}[way]
    return scene(f"3_chain_{way}_1:{ratio}", f"{title}, load 1:{ratio}",
                 f"A chain of 20 rods with a ball of {ratio} times a rod's mass at its end {what} for 10 s; "
                 "the error is the widest gap of a joint.",
                 "widest gap of a joint (m)", "joint_stretch_max_m")


def fallen(height):
    """The suite's rule for boxes of 1 m: the middle of the top is half a metre and 2 % of its height lower."""
    return 0.5 + 0.02 * (height - 0.5)


def stack(boxes):
    return scene(f"4_stack{boxes}", f"Stack of {boxes} boxes",
                 f"{boxes} boxes of 1 m stand on each other for 10 s; the error is how deep two of them overlap.",
                 "deepest overlap of two boxes (m)", "pen_max_m", fallen_m=fallen(boxes))


def heavy_top(ratio):
    return scene(f"4_heavy_top_x{ratio}", f"Stack, top {ratio} times as heavy",
                 f"10 boxes of 1 m carry one that is {ratio} times as heavy for 10 s; the error is how deep two overlap.",
                 "deepest overlap of two boxes (m)", "pen_max_m", fallen_m=fallen(11))


def incline(ratio, what):
    return scene(f"7_incline_{ratio}", f"Slope at {ratio} of what friction holds",
                 f"A box lies on a slope {ratio} times as steep as friction can hold, for 5 s: {what}; "
                 "the error is by how much the way it slid is wrong.",
                 "error of the way it slid (m)", "slip_err_m")


def drop(restitution):
    return scene(f"8_drop_e{restitution}", f"Bouncing ball, restitution {restitution}",
                 "A ball falls 4 m and bounces; the error is the worst height of its first five bounces.",
                 "error of the height (share of the drop)", "apex_maxerr_frac_of_h0")


def cluster(restitution):
    return scene(f"9_cluster_e{restitution}", f"Swirling cluster, restitution {restitution}",
                 "36 balls and boxes without friction fall into each other with a swirl and no gravity; "
                 "the error is how much of their angular momentum appears or vanishes.",
                 "drift of angular momentum (share)", "ang_mom_drift_rel")


def rod(spin):
    return scene(f"11_rod_free_w{spin}", f"Free rod, spinning at {spin} rad/s",
                 "A rod spins without gravity for 10 s; the error is by how much its angle is wrong then.",
                 "error of the angle (rad)", "ang_err_rad")


def cantilever(suffix, title, tip):
    return scene(f"11_cantilever10{suffix}", title,
                 f"10 boxes of 1 m are welded to each other and to a wall, {tip}; "
                 "the error is how far the last one sags, which should be nothing.",
                 "sag of the last box (m)", "tip_sag_max_m")


def bullet(kind, title, wall):
    return scene(f"10_bullet_{kind}", title,
                 f"20 small balls are shot at {wall}, at six speeds from 10 to 390 m/s; "
                 "the error is the share that passes through.",
                 "share that passes through", "tunnel_frac", 1e-3,
                 sources=[f"10_bullet_{kind}_v{speed}" for speed in BULLET_SPEEDS])


SCENES = [
    free(3),
    free(30),
    scene("2_pendulum", "Pendulum",
          "A rod on a pin swings for 60 s without friction; the error is how much of its energy it gains or loses.",
          "energy gained or lost (%)", "energy_end_pct", 1e-4, 1000.0),
    scene("2_double_pend", "Double pendulum",
          "Two rods in a row are let go level; the error is how far the tip gets from the exact path in 1 s.",
          "distance of the tip from its path (m)", "tip_err_max_1s_m"),
    chain("hang", 10),
    chain("hang", 100),
    chain("hang", 1000),
    chain("swing", 10),
    chain("swing", 100),
    chain("swing", 1000),
    stack(10),
    stack(20),
    stack(50),
    heavy_top(10),
    heavy_top(100),
    heavy_top(1000),
    scene("5_pyramid20", "Pyramid of 210 boxes",
          "A pyramid of boxes of 1 m, 20 wide, stands for 10 s; the error is how far any box moves.",
          "farthest that a box moves (m)", "disp_max_m"),
    scene("6_arch", "Arch without mortar",
          "31 wedges stand as a half circle by friction for 10 s; the error is how far the key stone sinks.",
          "sag of the key stone (m)", "key_sag_m"),
    incline("0.98", "it must stay"),
    incline("1.02", "it must slide just so far"),
    drop(1),
    drop(0.8),
    drop(0.5),
    cluster(0),
    cluster(0.5),
    cluster(1),
    bullet("static", "Bullets at fixed walls", "walls of 10 cm that are fixed"),
    bullet("dyn", "Bullets at loose walls", "walls of 10 cm that can move"),
    bullet("dynflag", "Marked bullets at loose walls",
           "walls of 10 cm that can move, the balls being marked as bullets"),
    rod(20),
    rod(100),
    cantilever("", "Cantilever of 10 boxes", "all equal"),
    scene("cloth", "Cloth of 256 balls",
          "A net of 16 x 16 balls on 480 pins hangs from seven of them and swings for 5 s; the error is the widest gap of a pin.",
          "widest gap of a pin (m)", "joint_stretch_max_m", sources=["joint_grid"], arguments=["--family", "joint_grid", "--set", "side=16"]),
    scene("crowd", "Crowd of 40 ragdolls",
          "40 ragdolls fall into a pit and move over each other for 10 s; the error is the widest gap of a joint.",
          "widest gap of a joint (m)", "joint_stretch_max_m", sources=["ragdolls"], arguments=["--family", "ragdolls", "--set", "count=40"]),
    cantilever("_tip100", "Cantilever with a heavy tip", "the last 100 times as heavy"),
]

# One page of what tells most, in the order of the panels.
SUMMARY = [
    "1_free_w30", "2_pendulum", "2_double_pend", "8_drop_e1",
    "3_chain_swing_1:10", "3_chain_swing_1:1000", "3_chain_hang_1:1000", "11_cantilever10_tip100",
    "4_stack20", "4_stack50", "4_heavy_top_x100", "4_heavy_top_x1000",
    "5_pyramid20", "6_arch", "7_incline_0.98", "9_cluster_e1",
    "cloth", "crowd",
]

# The README's picture: a few that are large enough to read, what is not won among them.
README = ["2_double_pend", "3_chain_swing_1:1000", "4_stack20", "5_pyramid20", "6_arch", "9_cluster_e1", "cloth", "crowd"]
