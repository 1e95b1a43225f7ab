// Reads .mcap files with the library that Foxglove and Lichtblick use: indexes, checksums, every message by the schema
// in the file, and every number of every state against the table. First argument: the folder of recordings; second:
// where the modules are installed.
import { readFileSync, readdirSync } from "node:fs";
import { open } from "node:fs/promises";
import { createRequire } from "node:module";
import { join } from "node:path";

const [folder, modules] = process.argv.slice(2);
const require = createRequire(join(modules, "package.json"));
const { McapIndexedReader, McapStreamReader } = require("@mcap/core");
const { createFileRegistry, fromBinary } = require("@bufbuild/protobuf");
const { FileDescriptorSetSchema } = require("@bufbuild/protobuf/wkt");
const fzstd = require("fzstd");

const decompressHandlers = { zstd: (packed, size) => fzstd.decompress(packed, new Uint8Array(Number(size))) };

function demand(condition, difference) {
  if (!condition) throw new Error(difference);
}

/** Columns by name, numbers by JavaScript's own reading of decimals. */
function table(path) {
  const [names, ...rows] = readFileSync(path, "utf8").trimEnd().split("\n").map((line) => line.split(","));
  const columns = new Map(names.map((name) => [name, new Float64Array(rows.length)]));
  rows.forEach((row, index) => names.forEach((name, place) => (columns.get(name)[index] = Number(row[place]))));
  return columns;
}

/** Of a decoded message, the messages of its schema. */
function decoder(schema) {
  demand(schema.encoding === "protobuf", `schema encoding ${schema.encoding}`);
  const type = createFileRegistry(fromBinary(FileDescriptorSetSchema, schema.data)).getMessage(schema.name);
  demand(type, `no ${schema.name} in its own description`);
  return { type, decode: (data) => fromBinary(type, data) };
}

/** The columns of a body by the fields of its states: a column belongs to the longest name that it begins with. */
function columnsByField(columns, prefix, fields) {
  const found = new Map(fields.map((field) => [field, []]));
  for (const name of columns.keys()) {
    if (name === "time_s" || !name.startsWith(prefix)) continue;
    const begins = fields.filter((field) => name.slice(prefix.length).startsWith(`${field.name}_`));
    demand(begins.length > 0, `column ${name} is in no field`);
    found.get(begins.reduce((a, b) => (a.name.length >= b.name.length ? a : b))).push(name);
  }
  return found;
}

/** The numbers of a field that is there, in the order of its schema. */
function numbers(state, field) {
  const value = state[field.localName];
  if (field.fieldKind === "message") return field.message.fields.map((leaf) => value[leaf.localName]);
  return [value];
}

/** Fails unless a column and the states have the same numbers: -0 is not 0. */
function compareColumn(column, name, states, number) {
  demand(column.length === states.length, `${name}: ${states.length} samples, the table has ${column.length}`);
  states.forEach((state, row) => {
    const value = number(state);
    demand(Object.is(value, column[row]), `${name}, sample ${row}: ${value}, the table has ${column[row]}`);
  });
}

function compareBody({ type, states }, prefix, columns) {
  const isChannel = (field) =>
    !["time_s", "timestamp"].includes(field.name) && states[0][field.localName] !== undefined;
  compareColumn(columns.get("time_s"), "time_s", states, (state) => state.timeS);
  let compared = 0;
  for (const [field, names] of columnsByField(columns, prefix, type.fields.filter(isChannel))) {
    const count = numbers(states[0], field).length;
    demand(count === names.length, `${field.name}: ${count} numbers for ${names.length} columns`);
    names.forEach((name, place) => {
      compareColumn(columns.get(name), name, states, (state) => numbers(state, field)[place]);
      compared += states.length;
    });
  }
  return compared;
}

async function check(name) {
  const path = join(folder, name);
  const file = await open(path);
  const readable = {
    size: async () => BigInt((await file.stat()).size),
    read: async (offset, size) => {
      const { bytesRead, buffer } = await file.read(new Uint8Array(Number(size)), 0, Number(size), Number(offset));
      demand(bytesRead === Number(size), "shorter than its indexes say");
      return buffer;
    },
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const decoders = new Map([...reader.schemasById].map(([id, schema]) => [id, decoder(schema)]));
  const bodies = new Map();
  let messages = 0;
  for await (const message of reader.readMessages()) {
    const channel = reader.channelsById.get(message.channelId);
    const { type, decode } = decoders.get(channel.schemaId);
    const decoded = decode(message.data);
    messages += 1;
    if (type.typeName !== "polhode.BodyState") continue;
    const { seconds, nanos } = decoded.timestamp;
    demand(seconds * 1000000000n + BigInt(nanos) === message.logTime, `${channel.topic}: stamp at ${message.logTime}`);
    // A body, or a point of one: body/point.
    const body = channel.topic.replace(/^\/body\//, "").replace(/\/state$/, "");
    if (!bodies.has(body)) bodies.set(body, { type, states: [] });
    bodies.get(body).states.push(decoded);
  }
  await file.close();
  demand(BigInt(messages) === reader.statistics.messageCount, `${messages} messages, statistics say otherwise`);
  let streamed = 0;
  const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  stream.append(readFileSync(path));
  for (let record; (record = stream.nextRecord()); ) streamed += record.type === "Message";
  demand(stream.done() && streamed === messages, `${streamed} messages from end to end, ${messages} by the indexes`);
  const columns = table(path.replace(/mcap$/, "csv"));
  let compared = columns.get("time_s").length;
  for (const [body, states] of bodies) {
    compared += compareBody(states, bodies.size > 1 ? `${body}.` : "", columns);
  }
  demand(compared === columns.size * columns.get("time_s").length, `${compared} values compared of the table's`);
  return `${messages} messages, ${compared} values`;
}

const recordings = readdirSync(folder).filter((name) => name.endsWith(".mcap")).sort();
process.exitCode = recordings.length > 0 ? 0 : 1;
for (const name of recordings) {
  try {
    console.log(`ok      ${name}: ${await check(name)}`);
  } catch (difference) {
    console.log(`FAILED  ${name}: ${difference.message}`);
    process.exitCode = 1;
  }
}
