// Reads a bag of rosbag2: metadata.yaml, and its MCAP file by @mcap/core, each message by its schema. Prints counts, the
// first and last message of each topic, and what is wrong. "read_bag.mjs FOLDER"
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { parse as parseYaml } from "yaml";
import { readerOf, toJson } from "./decoder.mjs";
import { openMcap } from "./indexed_mcap.mjs";

const folder = process.argv[2];
const information = parseYaml(readFileSync(join(folder, "metadata.yaml"), "utf8")).rosbag2_bagfile_information;
const { reader: bag, handle } = await openMcap(join(folder, information.relative_file_paths[0]));
const topics = {};
const readers = new Map();
for (const channel of bag.channelsById.values()) {
  const schema = bag.schemasById.get(channel.schemaId);
  readers.set(channel.id, readerOf(new TextDecoder().decode(schema.data)));
  topics[channel.topic] = {
    type: schema.name,
    schemaEncoding: schema.encoding,
    encoding: channel.messageEncoding,
    hash: channel.metadata.get("topic_type_hash"),
    qos: parseYaml(channel.metadata.get("offered_qos_profiles"))[0],
    messages: 0,
  };
}
for await (const message of bag.readMessages()) {
  const topic = topics[bag.channelsById.get(message.channelId).topic];
  topic.last = readers.get(message.channelId).readMessage(message.data);
  topic.last_ns = message.logTime;
  topic.first ??= topic.last;
  topic.messages += 1;
}
const metadata = {};
for await (const one of bag.readMetadata()) {
  metadata[one.name] = parseYaml(one.metadata.get("serialized_metadata"));
}
console.log(toJson({
  profile: bag.header.profile,
  statistics: bag.statistics.messageCount,
  first_ns: bag.statistics.messageStartTime,
  information,
  inFile: metadata.rosbag2,
  topics,
}));
await handle.close();
