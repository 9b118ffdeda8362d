// Reads a recording with @mcap/core, its IDL with @foxglove/omgidl-parser and its samples with
// @foxglove/omgidl-serialization, and prints per topic how many samples there are and the sum of all their numbers.
import { parseIDL } from "@foxglove/omgidl-parser";
import { MessageReader } from "@foxglove/omgidl-serialization";
import { openMcap } from "./indexed_mcap.mjs";

const { reader, handle } = await openMcap(process.argv[2]);
const decoders = new Map();
for (const channel of reader.channelsById.values()) {
  const schema = reader.schemasById.get(channel.schemaId);
  const definitions = parseIDL(new TextDecoder().decode(schema.data));
  decoders.set(channel.id, new MessageReader(schema.name, definitions));
}

function sumOf(value) {
  if (typeof value === "number" || typeof value === "bigint") {
    return Number(value);
  }
  if (typeof value === "string") {
    return [...value].reduce((sum, letter) => sum + letter.charCodeAt(0), 0);
  }
  return Object.values(value).reduce((sum, one) => sum + sumOf(one), 0);
}

const topics = {};
for (const channel of reader.channelsById.values()) {
  topics[channel.topic] = { samples: 0, sum: 0 };
}
for await (const message of reader.readMessages()) {
  const topic = topics[reader.channelsById.get(message.channelId).topic];
  topic.samples += 1;
  topic.sum += sumOf(decoders.get(message.channelId).readMessage(message.data));
}
const metadata = {};
for await (const one of reader.readMetadata()) {
  metadata[one.name] = Object.fromEntries(one.metadata);
}
console.log(JSON.stringify({ topics, metadata, statistics: Number(reader.statistics.messageCount) }));
await handle.close();
