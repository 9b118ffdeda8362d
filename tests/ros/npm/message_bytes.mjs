// Reads messages that Farrier wrote and writes them again; writes messages of its own. "message_bytes.mjs FILE": a list of
// {type, definition, hex}. Prints a list of {again, own}, of bytes as hex.
import { readFileSync } from "node:fs";
import { definitionsOf, readerOf, writerOf } from "./decoder.mjs";

const hexOf = (bytes) => Buffer.from(bytes).toString("hex");

// Numbers that differ from each other, without a random generator of the system.
let state = 12345;
function next(most) {
  state = (state * 1103515245 + 12345) % 2147483648;
  return state % (most + 1);
}

function valueOf(field, types) {
  if (field.isComplex) {
    return messageOf(types.find((type) => type.name === field.type), types);
  }
  switch (field.type) {
    case "string": return "xyz".repeat(next(4));
    case "bool": return next(1) === 1;
    case "float64": return (next(1_000_000) - 500_000) / 7;
    case "int8": return next(100);
    case "uint8": return next(255);
    case "int32": return next(2_000_000) - 1_000_000;
    case "uint32": return next(4_000_000);
    case "time":
    case "duration": return { sec: next(1_000_000), nsec: next(999_999_999) };
    default: throw new Error(`no value of ${field.type}`);
  }
}

function messageOf(type, types) {
  const message = {};
  for (const field of type.definitions) {
    if (field.isArray) {
      const length = field.arrayLength ?? next(4);
      message[field.name] = Array.from({ length }, () => valueOf(field, types));
    } else {
      message[field.name] = valueOf(field, types);
    }
  }
  return message;
}

const results = JSON.parse(readFileSync(process.argv[2], "utf8")).map(({ definition, hex }) => {
  const reader = readerOf(definition);
  const writer = writerOf(definition);
  const types = definitionsOf(definition);
  const main = types.find((type) => type.name === undefined) ?? types[0];
  return {
    again: hex.map((one) => hexOf(writer.writeMessage(reader.readMessage(Buffer.from(one, "hex"))))),
    own: hex.map(() => hexOf(writer.writeMessage(messageOf(main, types)))),
  };
});
console.log(JSON.stringify(results));
