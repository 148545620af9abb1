// Opens a 60 s record of the introduction program, written with --record-data all, by @mcap/core
// and checks that it holds what docs/records.md says.
//   node read_record.mjs FILE HASH
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

import { McapIndexedReader, McapStreamReader } from "@mcap/core";

const [, , file, expectedHash] = process.argv;
const bytes = readFileSync(file);

// By its index, as a viewer opens it; every checksum is compared.
const reader = await McapIndexedReader.Initialize({
  readable: {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) =>
      new Uint8Array(bytes.buffer, bytes.byteOffset + Number(offset), Number(length)),
  },
});
assert.match(reader.header.library, /^ccmorse \d+\.\d+\.\d+$/);

const schemaOf = {
  "/start": "ccmorse.Start",
  "/input": "ccmorse.Input",
  "/hash": "ccmorse.Hash",
  "/end": "ccmorse.End",
  "/tf": "foxglove.FrameTransforms",
  "/scene": "foxglove.SceneUpdate",
  "/s1r/hokuyo": "foxglove.LaserScan",
  "/s1r/pose": "foxglove.PoseInFrame",
  "/s1r/odometry": "ccmorse.Data",
  "/s1r/properties": "ccmorse.Data",
};
const channels = [...reader.channelsById.values()];
assert.deepEqual(channels.map((channel) => channel.topic).sort(), Object.keys(schemaOf).sort());
for (const channel of channels) {
  const schema = reader.schemasById.get(channel.schemaId);
  assert.equal(schema.name, schemaOf[channel.topic]);
  assert.equal(schema.encoding, "jsonschema");
  assert.equal(channel.messageEncoding, "json");
  assert.equal(JSON.parse(new TextDecoder().decode(schema.data)).title, schema.name);
}

const messages = {};
let last = 0n;
for await (const message of reader.readMessages({ validateCrcs: true })) {
  assert.ok(message.logTime >= last, "messages are in the order of their times");
  last = message.logTime;
  const { topic, schemaId } = reader.channelsById.get(message.channelId);
  const value = JSON.parse(new TextDecoder().decode(message.data));
  const schema = JSON.parse(new TextDecoder().decode(reader.schemasById.get(schemaId).data));
  check(value, schema, topic);
  (messages[topic] ??= []).push({ time: Number(message.logTime) / 1e9, ...value });
}

// The part of JSON schema that records use.
function check(value, schema, where) {
  const type = Array.isArray(value) ? "array" : typeof value;
  if (schema.type === "integer") {
    assert.ok(Number.isInteger(value), `${where} is an integer`);
  } else {
    assert.equal(type, schema.type, where);
  }
  if (type === "array") value.forEach((item, i) => check(item, schema.items, `${where}[${i}]`));
  if (type !== "object" || schema.properties === undefined) return;
  for (const [key, item] of Object.entries(value)) {
    if (schema.properties[key] !== undefined) check(item, schema.properties[key], `${where}.${key}`);
    else assert.equal(schema.title, "ccmorse.Data", `${where}.${key} is in the schema`);
  }
}

const counts = Object.fromEntries(Object.entries(messages).map(([k, v]) => [k, v.length]));
assert.equal(counts["/start"], 1);
assert.equal(counts["/end"], 1);
assert.equal(counts["/scene"], 1);
assert.equal(counts["/tf"], 600);
assert.equal(counts["/s1r/hokuyo"], 600);
assert.equal(counts["/s1r/pose"], 3600);
assert.equal(counts["/s1r/odometry"], 3600);
assert.equal(counts["/s1r/properties"], 60);
assert.equal(counts["/hash"], 3600);
assert.ok(counts["/input"] >= 600, "a command a reading");
for (const [topic, count] of Object.entries(counts)) {
  const id = channels.find((channel) => channel.topic === topic).id;
  assert.equal(reader.statistics.channelMessageCounts.get(id), BigInt(count));
}

const start = messages["/start"][0];
assert.equal(start.name, "syrotek");
assert.equal(start.format, 1);
assert.equal(start.scenario.robots[0].name, "s1r");
assert.equal(start.scenario.seed, 1);
const end = messages["/end"][0];
assert.equal(end.tick, 3600);
assert.equal(end.hash, expectedHash);
assert.equal(end.time, 60);
messages["/hash"].forEach((hash, i) => {
  assert.equal(hash.tick, i + 1);
  assert.match(hash.components.s1r, /^[0-9a-f]{16}$/);
  assert.match(hash.components.canvas, /^[0-9a-f]{16}$/);
});
for (const input of messages["/input"]) {
  assert.ok(Math.abs(input.tick / 60 - input.time) < 1e-8);
  assert.match(input.kind, /^(service|bytes)$/);
  if (input.kind === "service") assert.ok(Array.isArray(JSON.parse(input.arguments)));
  else assert.match(input.arguments, /^[A-Za-z0-9+/]+=*$/);
}
for (const scan of messages["/s1r/hokuyo"]) {
  assert.equal(scan.ranges.length, 682);
  assert.ok(scan.ranges.every((range) => range >= 0 && range <= 5));
  assert.ok(Math.abs(scan.timestamp.sec + scan.timestamp.nsec / 1e9 - scan.time) < 1e-8);
}
const pose = messages["/s1r/pose"].at(-1).pose;
const transform = messages["/tf"][0].transforms[0];
assert.equal(transform.child_frame_id, "s1r");
assert.ok(Math.hypot(pose.position.x - transform.translation.x, pose.position.y - transform.translation.y) > 0.1);
assert.ok(messages["/scene"][0].entities[0].cubes.length > 50, "the arena's boxes");

// From front to back, as a stream.
const stream = new McapStreamReader({ validateCrcs: true });
stream.append(bytes);
let records = 0;
while (stream.nextRecord() !== undefined) ++records;
assert.ok(stream.done() && records > 0);
console.log(`everything is there: ${Object.values(counts).reduce((a, b) => a + b)} messages`);
