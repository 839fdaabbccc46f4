// Writes recordings of one simple drive with the libraries of Foxglove, which share no code with this program:
// @mcap/core for the files, rosmsg2-serialization and rosmsg-serialization for the messages.
//
//   npm install @mcap/core @foxglove/rosmsg @foxglove/rosmsg2-serialization @foxglove/rosmsg-serialization \
//     @foxglove/rosmsg-msgs-common @foxglove/wasm-zstd lz4js
//   node write_mcap.mjs FOLDER
//
// The robot pitches for 3 s up to 0.2 rad while it drives 1.5 m. Then it stands for 3 s and presses with 17 N m. Its laser
// sees a slope of 0.2 rad under the tracks and flippers of that place, in the frame of the base.
import { createRequire } from "node:module";
import { writeFileSync } from "node:fs";
import { join } from "node:path";

const require = createRequire(join(process.cwd(), "x.js"));
const { McapWriter } = require("@mcap/core");
const { stringify } = require("@foxglove/rosmsg");
const ros2 = require("@foxglove/rosmsg2-serialization");
const ros1 = require("@foxglove/rosmsg-serialization");
const common = require("@foxglove/rosmsg-msgs-common");
const zstd = require("@foxglove/wasm-zstd");
const lz4 = require("lz4js");

const lines = 60;
const names = ["front_left_j", "front_right_j", "rear_left_j", "rear_right_j"];
const begin = 1_700_000_000n * 1_000_000_000n;
const pitchAt = (i) => (0.2 * Math.min(i, 30)) / 30;
const turn = (angle) => ({ x: 0, y: -Math.sin(angle / 2), z: 0, w: Math.cos(angle / 2) }); // ROS: nose down positive
const timeAt = (i) => begin + BigInt(i) * 100_000_000n;

function header(i, frame, isRos1) {
  const time = timeAt(i);
  const sec = Number(time / 1_000_000_000n), nanosec = Number(time % 1_000_000_000n);
  const stamp = isRos1 ? { sec, nsec: nanosec } : { sec, nanosec };
  return isRos1 ? { seq: i, stamp, frame_id: frame } : { stamp, frame_id: frame };
}

const wayAt = (i) => 0.05 * Math.min(i, 30);

function cloudAt(i, isRos1) {
  const rows = [-0.27, -0.2, 0.2, 0.27], inRow = 80, points = rows.length * inRow;
  const data = new DataView(new ArrayBuffer(12 * points));
  for (let k = 0; k < points; ++k) {
    const x = 1.01 + 0.02 * (k % inRow), z = k % inRow === 5 ? NaN : -0.12 + Math.tan(0.2) * (x - 1.5);
    [x - wayAt(i), rows[Math.floor(k / inRow)], z].forEach((value, axis) => data.setFloat32(12 * k + 4 * axis, value, true));
  }
  const field = (name, offset) => ({ name, offset, datatype: 7, count: 1 });
  return {
    header: header(i, "base_link", isRos1), height: 1, width: points, fields: [field("x", 0), field("y", 4), field("z", 8)],
    is_bigendian: false, point_step: 12, row_step: 12 * points, data: new Uint8Array(data.buffer), is_dense: false,
  };
}

/// Topic, type and message of every line.
function topics(isRos1) {
  const none9 = new Array(9).fill(0), none36 = new Array(36).fill(0), zero = { x: 0, y: 0, z: 0 };
  return [
    ["/imu/data", "sensor_msgs/Imu", (i) => ({
      header: header(i, "imu_link", isRos1), orientation: turn(pitchAt(i)), orientation_covariance: none9,
      angular_velocity: zero, angular_velocity_covariance: none9, linear_acceleration: { x: 0, y: 0, z: 9.81 },
      linear_acceleration_covariance: none9,
    })],
    ["/joint_states", "sensor_msgs/JointState", (i) => ({
      header: header(i, "", isRos1), name: names, position: [0.1, 0.2, 0.3, 0.4], velocity: [],
      effort: new Array(4).fill(i > 30 ? 17 : 0),
    })],
    ["/odom", "nav_msgs/Odometry", (i) => ({
      header: header(i, "odom", isRos1), child_frame_id: "base_link",
      pose: { pose: { position: { x: wayAt(i), y: 0, z: 0 }, orientation: turn(0) }, covariance: none36 },
      twist: { twist: { linear: zero, angular: zero }, covariance: none36 },
    })],
    ["/points", "sensor_msgs/PointCloud2", (i) => (i % 20 === 0 ? cloudAt(i, isRos1) : undefined)],
  ];
}

/// Returns the definition of a type with those that it uses.
function definitionOf(type, book) {
  const all = [{ ...book[type], name: undefined }], seen = new Set();
  for (let k = 0; k < all.length; ++k)
    for (const { type: used, isComplex } of all[k].definitions)
      if (isComplex && !seen.has(used)) seen.add(used), all.push({ ...book[used], name: used });
  return { text: stringify(all), all };
}

/// How the messages of a file are encoded.
const encodings = {
  cdr: {
    channel: "cdr", schema: "ros2msg", name: (type) => type.replace("/", "/msg/"),
    writer: (all) => new ros2.MessageWriter(all), book: common.ros2humble, isRos1: false,
  },
  ros1: {
    channel: "ros1", schema: "ros1msg", name: (type) => type, writer: (all) => new ros1.MessageWriter(all),
    book: common.ros1, isRos1: true,
  },
  json: {
    channel: "json", schema: "jsonschema", name: (type) => type,
    writer: () => ({ writeMessage: (m) => new TextEncoder().encode(JSON.stringify(m, (_, v) =>
      v instanceof Uint8Array ? Buffer.from(v).toString("base64") : v)) }),
    text: '{"type":"object"}', book: common.ros2humble, isRos1: false,
  },
  protobuf: {
    channel: "protobuf", schema: "protobuf", name: (type) => type, writer: () => ({ writeMessage: () => new Uint8Array(8) }),
    text: "\n\u0004a.proto", book: common.ros2humble, isRos1: false,
  },
};

class Bytes {
  parts = [];
  size = 0n;
  async write(bytes) { this.parts.push(Buffer.from(bytes)); this.size += BigInt(bytes.byteLength); }
  position() { return this.size; }
}

const compress = {
  zstd: (bytes) => ({ compression: "zstd", compressedData: zstd.compress(bytes, bytes.byteLength, 19) }),
  lz4: (bytes) => ({ compression: "lz4", compressedData: lz4.compress(bytes) }),
  strange: (bytes) => ({ compression: "brotli", compressedData: bytes }),
};
const unindexed = {
  useStatistics: false, useSummaryOffsets: false, repeatSchemas: false, repeatChannels: false, useAttachmentIndex: false,
  useMetadataIndex: false, useMessageIndex: false, useChunkIndex: false,
};

async function write(path, encoding, options = {}) {
  const out = new Bytes();
  const writer = new McapWriter({ writable: out, ...options });
  await writer.start({ profile: encoding === "ros1" ? "ros1" : "ros2", library: "write_mcap.mjs" });
  const e = encodings[encoding], channels = [];
  for (const [topic, type, make] of topics(e.isRos1)) {
    const { text, all } = definitionOf(type, e.book);
    const schemaId = await writer.registerSchema({
      name: e.name(type), encoding: e.schema, data: new TextEncoder().encode(e.text ?? text) });
    const id = await writer.registerChannel({ topic, schemaId, messageEncoding: e.channel, metadata: new Map() });
    channels.push({ id, make, writer: e.writer(all) });
  }
  for (let i = 0; i < lines; ++i)
    for (const channel of channels) {
      const message = channel.make(i);
      if (!message) continue;
      const logTime = timeAt(i);
      await writer.addMessage({
        channelId: channel.id, sequence: i, publishTime: logTime, logTime, data: channel.writer.writeMessage(message) });
    }
  await writer.end();
  writeFileSync(path, Buffer.concat(out.parts));
}

await zstd.isLoaded;
const folder = process.argv[2];
const at = (name) => join(folder, name);
await write(at("zstd.mcap"), "cdr", { compressChunk: compress.zstd });
await write(at("lz4_unindexed.mcap"), "cdr", { compressChunk: compress.lz4, chunkSize: 16384, ...unindexed });
await write(at("plain.mcap"), "cdr", { chunkSize: 8192 });
await write(at("unchunked.mcap"), "cdr", { useChunks: false });
await write(at("unchunked_unindexed.mcap"), "cdr", { useChunks: false, ...unindexed });
await write(at("ros1.mcap"), "ros1", { compressChunk: compress.zstd });
await write(at("json.mcap"), "json", { compressChunk: compress.zstd });
await write(at("protobuf.mcap"), "protobuf", { compressChunk: compress.zstd });
await write(at("unknown_compression.mcap"), "cdr", { compressChunk: compress.strange });
