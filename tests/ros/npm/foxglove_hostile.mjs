// Does to a server of Foxglove's protocol what no viewer should, and prints what came of each: the code that closed the
// connection, or the status that was answered.
import WebSocket from "ws";
import { request } from "node:http";

const url = process.argv[2];
const kLimit_ms = 20_000;

/// Opens a connection, does this once channels are advertised, and resolves with the answer.
function after(act) {
  return new Promise((resolve) => {
    const socket = new WebSocket(url, ["foxglove.websocket.v1"]);
    const limit = setTimeout(() => resolve("no answer"), kLimit_ms);
    const end = (what) => {
      clearTimeout(limit);
      resolve(what);
      socket.terminate();
    };
    socket.on("message", (data, binary) => {
      const message = binary ? {} : JSON.parse(data.toString());
      if (message.op === "advertise") {
        act(socket);
      } else if (message.op === "status") {
        end(`status ${message.level}: ${message.message}`);
      }
    });
    socket.on("close", (code) => end(`closed ${code}`));
    socket.on("error", () => {});
  });
}

/// Status of the answer to an upgrade with these protocols.
function upgrade(protocols) {
  return new Promise((resolve) => {
    const headers = {
      Connection: "Upgrade",
      Upgrade: "websocket",
      "Sec-WebSocket-Version": "13",
      "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==",
      ...(protocols === "" ? {} : { "Sec-WebSocket-Protocol": protocols }),
    };
    const asked = request(url.replace("ws:", "http:"), { headers });
    asked.on("response", (response) => resolve(response.statusCode));
    asked.on("upgrade", (response, socket) => {
      socket.destroy();
      resolve(`${response.statusCode} ${response.headers["sec-websocket-protocol"]}`);
    });
    asked.on("error", (error) => resolve(error.message));
    asked.end();
  });
}

const subscribe = (id, channelId) => JSON.stringify({ op: "subscribe", subscriptions: [{ id, channelId }] });
const results = {
  garbage: await after((s) => s.send("{]")),
  noObject: await after((s) => s.send("7")),
  deep: await after((s) => s.send("[".repeat(60_000))),
  unknownOp: await after((s) => s.send('{"op":"dance"}')),
  unknownChannel: await after((s) => s.send(subscribe(1, 4_000_000_000))),
  noNumbers: await after((s) => s.send('{"op":"subscribe","subscriptions":[{"id":-1,"channelId":"a"},7,null]}')),
  twice: await after((s) => {
    s.send(subscribe(1, 0));
    s.send(subscribe(2, 0));
  }),
  unknownSubscription: await after((s) => s.send('{"op":"unsubscribe","subscriptionIds":[5]}')),
  huge: await after((s) => s.send("x".repeat(10_000_000))),
  binary: await after((s) => s.send(new Uint8Array([1, 0, 0, 0, 0, 1, 2, 3]))),
  noUtf8: await after((s) => s.send(Buffer.from([0xc3, 0x28]), { binary: false })),
  noFrame: await after((s) => s._socket.write(Buffer.from([0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff]))),
  noProtocol: await upgrade(""),
  otherProtocol: await upgrade("chat, soap"),
  bothProtocols: await upgrade("foxglove.sdk.v1, foxglove.websocket.v1"),
};
console.log(JSON.stringify(results));
