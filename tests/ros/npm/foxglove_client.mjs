// Subscribes to every channel of a server of Foxglove's protocol by npm's client, until each has had a message, and prints
// what it has decoded. "foxglove_client.mjs URL SUBPROTOCOL [TOPIC...]": without topics all channels count.
import { createRequire } from "node:module";
import WebSocket from "ws";
import { readerOf, toJson } from "./decoder.mjs";
const { FoxgloveClient } = createRequire(import.meta.url)("@foxglove/ws-protocol");

const [url, subprotocol, ...wanted] = process.argv.slice(2);
const kLimit_ms = 45_000;
const socket = new WebSocket(url, [subprotocol]);
const client = new FoxgloveClient({ ws: socket });
const channels = new Map(); // by subscription
const seen = { server: null, subprotocol: "", statuses: [], topics: {} };

function finish(status) {
  console.log(toJson(seen));
  process.exit(status);
}
setTimeout(() => finish(1), kLimit_ms);
client.on("error", (error) => {
  console.error(error.message);
  finish(2);
});
client.on("open", () => {
  seen.subprotocol = socket.protocol;
});
client.on("serverInfo", (info) => {
  seen.server = info;
});
client.on("status", (status) => seen.statuses.push(status.message));
client.on("advertise", (advertised) => {
  for (const channel of advertised) {
    seen.topics[channel.topic] = {
      type: channel.schemaName,
      encoding: channel.encoding,
      schemaEncoding: channel.schemaEncoding,
      messages: 0,
    };
    channels.set(client.subscribe(channel.id), { channel, reader: readerOf(channel.schema) });
  }
});
client.on("message", ({ subscriptionId, timestamp, data }) => {
  const { channel, reader } = channels.get(subscriptionId);
  const topic = seen.topics[channel.topic];
  topic.message = reader.readMessage(data);
  topic.time_ns = timestamp;
  topic.messages += 1;
  const needed = wanted.length > 0 ? wanted.map((name) => seen.topics[name]) : Object.values(seen.topics);
  if (needed.every((one) => one && one.messages > 0)) {
    finish(0);
  }
});
