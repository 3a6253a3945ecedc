// Messages of ROS for tests, with what they leave unsaid.

Object.assign(window, {
  time: (seconds = 0) => ({ sec: Math.floor(seconds), nanosec: Math.round((seconds % 1) * 1e9) }),
  header: (frame = "map", seconds = 0) => ({ frame_id: frame, stamp: window.time(seconds) }),
  pose: (x = 0, y = 0, z = 0, yaw = 0) => ({
    position: { x, y, z }, orientation: { x: 0, y: 0, z: Math.sin(yaw / 2), w: Math.cos(yaw / 2) },
  }),
  color: (r, g, b, a = 1) => ({ r, g, b, a }),
  points: (...all) => all.map(([x, y, z = 0]) => ({ x, y, z })),
  transform(parent, child, [x, y, z] = [0, 0, 0], yaw = 0, seconds = 0) {
    const { orientation } = window.pose(0, 0, 0, yaw);
    return {
      header: window.header(parent, seconds), child_frame_id: child,
      transform: { translation: { x, y, z }, rotation: orientation },
    };
  },
  marker: (own) => ({
    header: window.header(), ns: "test", id: 0, type: 1, action: 0, pose: window.pose(), scale: { x: 1, y: 1, z: 1 },
    color: window.color(1, 0, 0), lifetime: window.time(), frame_locked: false, points: [], colors: [], text: "",
    mesh_resource: "", mesh_use_embedded_materials: false, ...own,
  }),
  /** A cloud of points with float fields x, y, z and others, from rows of numbers. */
  cloud(rows, names = ["x", "y", "z"], own = {}) {
    const step = names.length * 4;
    const data = new Uint8Array(rows.length * step);
    const view = new DataView(data.buffer);
    rows.forEach((row, index) => row.forEach((value, field) => {
      view.setFloat32(index * step + field * 4, value, !own.is_bigendian);
    }));
    const fields = names.map((name, index) => ({ name, offset: index * 4, datatype: 7, count: 1 }));
    return {
      header: window.header(), width: rows.length, height: 1, fields, point_step: step, row_step: data.length,
      is_bigendian: false, data, is_dense: true, ...own,
    };
  },
  /** Rows of points that fill a square, for what is too small to hit. */
  square(x, y, ...more) {
    const rows = [];
    for (let i = -4; i <= 4; i++) for (let j = -4; j <= 4; j++) rows.push([x + i * 0.02, y + j * 0.02, 0, ...more]);
    return rows;
  },
});
