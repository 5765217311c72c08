# SPDX-License-Identifier: MIT
"""Load and friction of the block over time, and their quotient."""
from figure_style import SOLID, draw, plt


def pictures(run) -> list[tuple]:
    """(figure, kind, caption) of each picture for the report."""
    contact, sole = run.table("solid/contact.csv"), run.table("solid/probes.csv")
    figure, (top, low) = plt.subplots(2, 1, figsize=(7, 5), sharex=True, layout="constrained")
    draw(top, contact["t"], contact["back.normal_z"] + contact["back.friction_z"], color=SOLID, label="up")
    draw(top, contact["t"], -contact["back.normal_x"] - contact["back.friction_x"], color="0.4", label="against the slide")
    top.set(ylabel="force of the ground [N]")
    top.legend(fontsize=8)
    draw(low, sole["t"], 1e3 * sole["sole.ux"], color=SOLID, label="sole, x")
    low.set(xlabel="t [s]", ylabel="way [mm]")
    return [(figure, "svg", "What the dry ground does to the block, up and against the slide, and the way of its sole.")]
