// A graph in which chance starts, stops, kills, creates, destroys, publishes and slows down, and what has to
// be true of it when it has come to rest.

import { complaints, graph, random, start, until } from "./peers.js";
import { splitGid, gidOf } from "./runtime/protocol.js";

const PEERS = 12;
const TOPICS = 8;
const ENDPOINTS = 10;
const SIZES = [4, 4, 4, 100, 2000, 2000, 70_000];
// What a publisher that keeps all keeps for late comers.
const KEPT = 5000;

/** By chance, `steps` things happen to a graph. Resolves with what is wrong in the end. */
export async function play(seed, steps) {
  const next = random(seed);
  const below = (count) => Math.floor(next() * count);
  const oneOf = (list) => list[below(list.length)];
  /** Each has its endpoints by id. */
  const peers = new Set();
  /** The endpoints that there ever were, by gid. */
  const all = new Map();

  const qos = () => ({
    keepAll: next() < 0.4,
    depth: 1 + below(20),
    reliable: next() < 0.7,
    transientLocal: next() < 0.3,
  });
  const actions = {
    start() {
      if (peers.size === PEERS) return;
      peers.add({ ...start(`peer ${all.size}`), endpoints: new Map(), made: 0 });
    },
    kill(peer) {
      peers.delete(peer);
      peer.kill();
    },
    stop(peer) {
      peers.delete(peer);
      peer.ask("destroyAll").then(peer.kill);
    },
    create(peer) {
      if (peer.endpoints.size === ENDPOINTS) return;
      const kind = oneOf(["publisher", "subscription"]);
      const endpoint = { kind, topic: `/t${below(TOPICS)}`, qos: qos() };
      // Endpoints of a worker are numbered in the order of their coming.
      peer.made += 1;
      peer.endpoints.set(peer.made, endpoint);
      all.set(gidOf(peer.id, peer.made), endpoint);
      peer.ask("create", endpoint);
    },
    destroy(peer) {
      const id = oneOf([...peer.endpoints.keys()]);
      if (!id) return;
      peer.endpoints.delete(id);
      peer.ask("destroy", { id });
    },
    publish(peer) {
      const id = oneOf([...peer.endpoints.keys()]);
      const size = oneOf(SIZES);
      const count = 1 + below(next() < 0.3 ? 4000 : 50);
      if (id) peer.ask("publish", { id, size, count: Math.min(count, 5e6 / size) });
    },
    slow: (peer) => peer.ask("eat", { count: oneOf([1, 5, 50, 0, Infinity, Infinity]) }),
    block: (peer) => peer.ask("block", { duration: below(40) }),
  };
  const often = { start: 8, kill: 1, stop: 1, create: 30, destroy: 8, publish: 120, slow: 28, block: 6 };
  const bag = Object.entries(often).flatMap(([name, count]) => Array(count).fill(name));

  for (let step = 0; step < steps; step++) {
    const peer = oneOf([...peers]);
    const action = peer ? oneOf(bag) : "start";
    actions[action](peer);
    if (next() < 0.2) await new Promise((resolve) => setTimeout(resolve, below(8)));
  }

  for (const peer of peers) peer.ask("eat", { count: Infinity });
  let end = {};
  await until(async () => (end = await judge(peers, all)).wrong.length === 0).catch(() => {});
  for (const peer of peers) peer.kill();
  return { ...end, wrong: [...end.wrong, ...complaints], alive: peers.size, left: graph.topics() };
}

/** What is not as it has to be once all is at rest, and how many messages those heard that live. */
async function judge(peers, all) {
  const told = new Map();
  await Promise.all([...peers].map(async (peer) => told.set(peer.id, await peer.ask("tell"))));
  const wrong = [];
  const check = (right, text) => right || wrong.push(text);
  const living = [...peers].flatMap((peer) =>
    [...peer.endpoints].map(([id, endpoint]) => ({ ...endpoint, gid: gidOf(peer.id, id) })));
  const publishers = living.filter(({ kind }) => kind === "publisher");
  const subscriptions = living.filter(({ kind }) => kind === "subscription");
  const state = ({ kind, gid }) => {
    const { peer, id } = splitGid(gid);
    return told.get(peer)[`${kind}s`].get(id);
  };
  let [bad, heard] = [0, 0];

  for (const { faults } of told.values()) wrong.push(...faults);
  const known = graph.endpoints().map(({ id, kind, name }) => `${id} ${kind} ${name}`);
  const real = living.map(({ gid, kind, topic }) => `${splitGid(gid).id} ${kind} ${topic}`);
  check(String(known.sort()) === String(real.sort()), `the graph has ${known}, not ${real}`);

  for (const s of subscriptions) {
    const { writers, matched } = state(s);
    const suiting = publishers.filter((p) => meet(p, s));
    bad += publishers.filter((p) => p.topic === s.topic).length - suiting.length;
    check(matched === suiting.length, `${s.gid} matches ${matched} of ${suiting.length}`);
    for (const [writer, { first, last, count }] of writers) {
      heard += count;
      const p = all.get(writer);
      check(meet(p, s), `${s.gid} heard ${writer}, which does not suit`);
      if (strict(p) && strict(s)) {
        check(count === last - first + 1, `${s.gid} heard ${count} of ${writer}, from ${first} to ${last}`);
      }
    }
    for (const p of suiting) {
      const { number, began, waiting } = state(p);
      check(waiting === 0, `${p.gid} still waits with ${waiting}`);
      const before = began.get(s.gid);
      const kept = p.qos.transientLocal && s.qos.transientLocal ? (p.qos.keepAll ? KEPT : p.qos.depth) : 0;
      const first = Math.max(before - kept, 0) + 1;
      if (first > number) {
        check(!writers.has(p.gid), `${s.gid} heard ${p.gid}, which said nothing since`);
        continue;
      }
      const got = writers.get(p.gid) ?? { first: 0, last: 0 };
      const text = `${s.gid} heard ${p.gid} from ${got.first} to ${got.last}, not from ${first} to ${number}`;
      // The messages of several publishers push each other out of a queue.
      const crowded = !s.qos.keepAll && [...all.values()].filter((e) => meet(e, s)).length > 1;
      if (!crowded) check(got.last === number, text);
      check(strict(p) && strict(s) ? got.first === first : crowded || got.first >= first, text);
    }
  }
  for (const p of publishers) {
    const suiting = subscriptions.filter((s) => meet(p, s));
    const { matched } = state(p);
    check(matched === suiting.length, `${p.gid} matches ${matched} of ${suiting.length}`);
  }
  const mismatches = graph.topics().flatMap((topic) => topic.mismatches);
  check(mismatches.length === bad, `${mismatches.length} mismatches instead of ${bad}`);
  return { wrong, heard };
}

/** Whether a publisher and a subscription match. */
function meet(p, s) {
  return p.kind === "publisher" && p.topic === s.topic &&
    p.qos.reliable >= s.qos.reliable && p.qos.transientLocal >= s.qos.transientLocal;
}

/** Whether nothing may be lost, if it is true of both sides. */
function strict({ qos }) {
  return qos.keepAll && qos.reliable;
}
