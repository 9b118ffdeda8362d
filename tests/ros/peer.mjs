// A node of RTPS that nobody at Farrier wrote looks at a robot: what it discovers, and what it reads. Prints it as JSON.
// Arguments: domain, namespace, seconds to read joint states for.
import { CdrReader } from "@foxglove/cdr";
import rtps from "@foxglove/rtps";
import rtpsNode from "@foxglove/rtps/nodejs";

const [domain, namespace, seconds] = process.argv.slice(2);
const began = Date.now();
const since = () => (Date.now() - began) / 1000;

const participant = new rtps.Participant({
  name: "peer",
  addresses: ["127.0.0.1"],
  domainId: Number(domain),
  udpSocketCreate: rtpsNode.UdpSocketNode.Create,
});
const seen = { participants: [], topics: {}, graph: null, joints: null, description: 0, description_s: 0 };

participant.on("discoveredParticipant", (other) => {
  seen.participants.push({ userData: other.userData ?? "", found_s: since() });
});
participant.on("discoveredPublication", (writer) => {
  seen.topics[writer.topicName] = {
    type: writer.typeName,
    reliable: writer.reliability.kind === rtps.Reliability.Reliable,
    kept: writer.durability === rtps.Durability.TransientLocal,
    userData: writer.userData ?? "",
    guid: writer.guidPrefix + writer.entityId.toString(16).padStart(8, "0"),
  };
});

const hex = (bytes) => Buffer.from(bytes).toString("hex");
const array = (cdr, read) => Array.from({ length: cdr.sequenceLength() }, read);
const gid = (cdr) => hex(cdr.uint8Array(16));

function readGraph(cdr) {
  const participantGid = gid(cdr);
  const nodes = array(cdr, () => ({
    namespace: cdr.string(),
    name: cdr.string(),
    readers: array(cdr, () => gid(cdr)),
    writers: array(cdr, () => gid(cdr)),
  }));
  return { participant: participantGid, nodes };
}

function readJoints(cdr) {
  const stamp_s = cdr.int32() + 1e-9 * cdr.uint32();
  cdr.string();
  const names = array(cdr, () => cdr.string());
  const position = Array.from(cdr.float64Array());
  return { stamp_s, names, position };
}

const joints = { count: 0, missing: 0, backwards: 0, first_s: 0, last_s: 0, names: 0, finite: true };
const sequences = new Set(); // a sample that is sent again may come twice
let newest = { sequence: 0n, stamp_s: 0 };

participant.on("userData", (sample) => {
  const cdr = new CdrReader(sample.serializedData);
  const topic = sample.publication.topicName;
  if (topic === "ros_discovery_info") {
    seen.graph = readGraph(cdr);
  } else if (topic.endsWith("/robot_description") && seen.description === 0) {
    seen.description = cdr.string().length;
    seen.description_s = since();
  } else if (topic.endsWith("/joint_states")) {
    const message = readJoints(cdr);
    const sequence = sample.writerSeqNumber;
    if (sequences.has(sequence)) {
      return;
    }
    sequences.add(sequence);
    joints.first_s = joints.count === 0 ? since() : joints.first_s;
    if (sequence > newest.sequence) {
      joints.backwards += message.stamp_s > newest.stamp_s ? 0 : 1;
      newest = { sequence, stamp_s: message.stamp_s };
    }
    joints.count += 1;
    joints.last_s = since();
    joints.names = message.names.length;
    joints.finite = joints.finite && message.position.length === message.names.length && message.position.every(Number.isFinite);
  }
});

const subscribe = (topicName, typeName, kept, depth) =>
  participant.subscribe({
    topicName,
    typeName,
    durability: kept ? rtps.Durability.TransientLocal : rtps.Durability.Volatile,
    reliability: { kind: rtps.Reliability.Reliable, maxBlockingTime: { sec: 0, nsec: 0 } },
    history: { kind: rtps.HistoryKind.KeepLast, depth },
  });

await participant.start();
subscribe("ros_discovery_info", "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_", true, 1);
subscribe(`rt${namespace}/robot_description`, "std_msgs::msg::dds_::String_", true, 1);
subscribe(`rt${namespace}/joint_states`, "sensor_msgs::msg::dds_::JointState_", false, 100);

const patience_s = 30;
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
while (since() < patience_s && (joints.count === 0 || seen.description === 0 || seen.graph === null)) {
  await wait(50);
}
while (joints.count > 0 && joints.last_s - joints.first_s < Number(seconds) && since() < patience_s + Number(seconds)) {
  await wait(50);
}
const first = [...sequences].reduce((one, other) => (other < one ? other : one), newest.sequence);
joints.missing = joints.count === 0 ? 0 : Number(newest.sequence - first) + 1 - joints.count;
seen.joints = joints;
console.log(JSON.stringify(seen));
process.exit(0);
