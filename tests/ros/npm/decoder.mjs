// Decodes messages of ROS 2 by their definitions, with @foxglove/rosmsg and @foxglove/rosmsg2-serialization.
import { createRequire } from "node:module";
const require = createRequire(import.meta.url);
const { parse } = require("@foxglove/rosmsg");
const { MessageReader, MessageWriter } = require("@foxglove/rosmsg2-serialization");

export function readerOf(definition) {
  return new MessageReader(parse(definition, { ros2: true }));
}
export function writerOf(definition) {
  return new MessageWriter(parse(definition, { ros2: true }));
}
export const definitionsOf = (definition) => parse(definition, { ros2: true });

/// JSON with numbers of 64 bits and typed arrays as plain ones.
export function toJson(value) {
  return JSON.stringify(value, (_, one) =>
    typeof one === "bigint" ? Number(one) : ArrayBuffer.isView(one) ? Array.from(one) : one);
}
