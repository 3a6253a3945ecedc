"""Transforms between frames, as tf2 has them: the latest, many, and more than there is room for."""

from __future__ import annotations

from playwright.sync_api import Page as Tab

MODULE = "./runtime/widgets/tf/transforms.js"
HELPERS = """
  const { Transforms } = await import(MODULE);
  const stamped = (parent, child, time, position = [1, 0, 0], rotation = [0, 0, 0, 1]) => ({
    header: { frame_id: parent, stamp: { sec: Math.floor(time), nanosec: (time % 1) * 1e9 } },
    child_frame_id: child,
    transform: {
      translation: { x: position[0], y: position[1], z: position[2] },
      rotation: { x: rotation[0], y: rotation[1], z: rotation[2], w: rotation[3] },
    },
  });
""".replace("MODULE", repr(MODULE))


def test_the_latest_pose_is_that_of_its_time(stage: Tab) -> None:
    """Asked for alone, after others in the same frame, and by its time, it is the same."""
    found = stage.evaluate(
        f"""async () => {{ {HELPERS}
          let seed = 5;
          const chance = (most) => Math.floor((seed = (seed * 48271) % 2147483647) / 2147483647 * most);
          const close = (a, b) => [...a.position, ...a.rotation].every(
            (part, index) => Math.abs(part - [...b.position, ...b.rotation][index]) < 1e-9);
          const counts = {{ same: 0, none: 0, wrong: [] }};
          for (let round = 0; round < 60; round++) {{
            const all = [];
            const kept = new Transforms();
            const size = 3 + chance(12);
            for (let step = 0; step < 40; step++) {{
              const child = 1 + chance(size);
              const parent = chance(8) ? chance(child) : chance(size);
              const parts = Array.from({{ length: 7 }}, () => chance(1000) / 1000 + 0.01);
              const one = [stamped(`f${{parent}}`, `f${{child}}`, 1 + chance(16) / 2, parts, parts.slice(3)), chance(4) === 0];
              all.push(one);
              kept.add(...one);
              for (const [target, source] of [[chance(size), chance(size)], [0, child], [child, 0]]) {{
                const alone = new Transforms();
                for (const each of all) alone.add(...each);
                const names = [`f${{target}}`, `f${{source}}`];
                const [a, b] = [kept.lookup(...names), alone.lookup(...names)];
                const there = Number.isFinite(a.time) ? alone.lookup(...names, a.time) : b;
                const poses = [a.pose, b.pose, there.pose];
                if (poses.every((pose) => !pose)) counts.none++;
                else if (poses.every(Boolean) && close(a.pose, b.pose) && close(a.pose, there.pose)) counts.same++;
                else counts.wrong.push([round, step, ...names, a, b, there]);
              }}
            }}
          }}
          return counts;
        }}"""  # noqa: E501
    )
    assert found["wrong"] == []
    assert found["same"] > 1000
    assert found["none"] > 100


def test_of_too_many_frames_the_silent_ones_are_forgotten(stage: Tab) -> None:
    found = stage.evaluate(
        f"""async () => {{ {HELPERS}
          const transforms = new Transforms();
          transforms.add(stamped("map", "fixed", 0), true);
          transforms.add(stamped("map", "first", 1), false);
          transforms.add(stamped("map", "second", 1), false);
          transforms.add(stamped("map", "first", 2), false);
          for (let n = 0; n < 9_998; n++) transforms.add(stamped("map", `f${{n}}`, 1), false);
          const known = ["fixed", "first", "second", "f0", "f9997"].map((each) =>
            [each, Boolean(transforms.lookup("map", each).pose)]);
          return {{ known: Object.fromEntries(known), count: transforms.frames().length }};
        }}"""
    )
    assert found["known"] == {
        **{"fixed": True, "first": True, "second": False, "f0": True, "f9997": True}
    }
    assert found["count"] == 10_001


def test_a_long_chain_is_right_from_both_ends(stage: Tab) -> None:
    found = stage.evaluate(
        f"""async () => {{ {HELPERS}
          const transforms = new Transforms();
          for (let n = 1; n < 1000; n++) {{
            transforms.add(stamped(`f${{n - 1}}`, `f${{n}}`, 1), false);
          }}
          const far = (target, source) => transforms.lookup(target, source).pose.position[0];
          return [
            transforms.frames().map((each) => far("f0", each)).sort((a, b) => a - b).at(-1),
            transforms.frames().map((each) => far("f999", each)).sort((a, b) => a - b)[0],
            far("f500", "f499"), far("f500", "f501"),
          ];
        }}"""
    )
    assert found == [999, -999, -1, 1]
