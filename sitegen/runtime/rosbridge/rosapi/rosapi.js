// @ts-check
// The services of rosapi, which tell clients what the graph has. They answer without being in the graph.

import { stamp } from "../../messages/time.js";
import { isHidden } from "../../graphNames.js";
import { actionsOf } from "../../messages/actionClient.js";
import { Mistake } from "../mistake.js";
import { fullText, PARTS, typedefs, typeNamed, withoutPackage } from "./definitions.js";
import { ParameterServices } from "./parameters.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Session } from "../session.js" */

const NODE = "/rosapi";
const DISTRIBUTION = "kilted";
/** The fields that requests have. */
const FIELDS = ["topic", "service", "action", "node", "type", "name", "value", "default", "default_value"];
/** The types of the services, after rosapi_msgs/srv/. @type {Record<string, string>} */
const TYPES = {
  topics: "Topics", interfaces: "Interfaces", topics_for_type: "TopicsForType", topics_and_raw_types: "TopicsAndRawTypes",
  topic_type: "TopicType", services: "Services", services_for_type: "ServicesForType", service_type: "ServiceType",
  service_node: "ServiceNode", service_providers: "ServiceProviders", nodes: "Nodes", node_details: "NodeDetails",
  publishers: "Publishers", subscribers: "Subscribers", action_servers: "GetActionServers", action_type: "ActionType",
  message_details: "MessageDetails", service_request_details: "ServiceRequestDetails",
  service_response_details: "ServiceResponseDetails", service_typedescs: "ServiceTypedescs",
  action_goal_details: "ActionGoalDetails", action_result_details: "ActionResultDetails",
  action_feedback_details: "ActionFeedbackDetails", get_time: "GetTime", get_ros_version: "GetROSVersion",
  get_param: "GetParam", set_param: "SetParam", has_param: "HasParam", delete_param: "DeleteParam",
  get_param_names: "GetParamNames",
};

export class Rosapi {
  #session;
  /** @type {Record<string, (request: any) => any>} */
  #services;

  /** @param {Session} session */
  constructor(session) {
    this.#session = session;
    this.#services = {
      ...this.#aboutTopics(), ...this.#aboutServices(), ...this.#aboutNodes(), ...this.#aboutTypes(),
      ...new ParameterServices(session).services,
      get_time: () => ({ time: stamp() }),
      get_ros_version: () => ({ version: 2, distro: DISTRIBUTION }),
    };
  }

  /**
   * Return what answers a service of rosapi, if it is one.
   * @param {string} name @returns {((request: any) => any) | undefined}
   */
  serviceOf(name) {
    const own = name.startsWith(`${NODE}/`) ? name.slice(NODE.length + 1) : "";
    const answer = Object.hasOwn(this.#services, own) ? this.#services[own] : undefined;
    return answer && ((request) => answer(textsOf(request)));
  }

  /** @returns {Record<string, (request: any) => any>} */
  #aboutTopics() {
    const { graph, values, raw } = this.#session;
    const topics = () => graph.topics().filter(({ name, types }) => !isHidden(name) && types.length);
    const found = (/** @type {unknown} */ topic) => graph.topics().find(({ name }) => name === topic);
    const listed = () => ({ topics: topics().map(({ name }) => name), types: topics().map(({ types }) => types[0]) });
    return {
      topics: listed,
      topics_for_type: ({ type }) => ({
        topics: topics().filter(({ types }) => same(types[0], type)).map(({ name }) => name),
      }),
      topics_and_raw_types: async () => {
        const all = listed();
        const texts = await Promise.all(all.types.map((type) =>
          (type && values.knows(type) ? fullText(values, raw.types, type)
            : `# failed to get full definition text for ${type}: this page has no definition of it`)));
        return { ...all, typedefs_full_text: texts };
      },
      topic_type: ({ topic }) => ({ type: topics().find(({ name }) => name === topic)?.types[0] ?? "" }),
      publishers: ({ topic }) => ({ publishers: once(found(topic)?.publishers) }),
      subscribers: ({ topic }) => ({ subscribers: once(found(topic)?.subscriptions) }),
    };
  }

  /** @returns {Record<string, (request: any) => any>} */
  #aboutServices() {
    const { graph } = this.#session;
    const own = Object.entries(TYPES).map(([name, type]) =>
      ({ name: `${NODE}/${name}`, types: [`rosapi_msgs/srv/${type}`], servers: [NODE], clients: [] }));
    const all = () => [...graph.services().filter(({ servers }) => servers.length), ...own];
    const services = () => all().filter(({ name }) => !isHidden(name));
    const found = (/** @type {unknown} */ service) => all().find(({ name }) => name === service);
    const actions = () => actionsOf(/** @type {Ros} */ (/** @type {unknown} */ ({ graph })));
    return {
      services: () => ({ services: services().map(({ name }) => name) }),
      services_for_type: ({ type }) => ({
        services: services().filter(({ types }) => same(types[0], type)).map(({ name }) => name),
      }),
      service_type: ({ service }) => ({ type: services().find(({ name }) => name === service)?.types[0] ?? "" }),
      service_node: ({ service }) => ({ node: found(service)?.servers[0] ?? "" }),
      service_providers: ({ service }) => ({
        providers: once([...(found(service)?.servers ?? []),
          ...services().filter(({ types }) => same(types[0], service)).flatMap(({ servers }) => servers)]),
      }),
      action_servers: () => ({
        action_servers: actions().filter(({ servers }) => servers.length).map(({ name }) => name),
      }),
      action_type: ({ action }) => ({ type: actions().find(({ name }) => name === action)?.types[0] ?? "" }),
    };
  }

  /** @returns {Record<string, (request: any) => any>} */
  #aboutNodes() {
    const { graph } = this.#session;
    const nodes = () => once([...graph.nodes().filter((name) => !isHidden(name)), NODE]);
    const shown = (/** @type {{name: string}[]} */ all) => all.map(({ name }) => name).filter((name) => !isHidden(name));
    return {
      nodes: () => ({ nodes: nodes() }),
      node_details: ({ node }) => {
        if (!nodes().includes(node)) throw new Mistake(`there is no node '${node.slice(0, 200)}'`);
        return {
          subscribing: shown(graph.topics().filter(({ subscriptions }) => subscriptions.includes(node))),
          publishing: shown(graph.topics().filter(({ publishers }) => publishers.includes(node))),
          services: node === NODE ? Object.keys(TYPES).map((name) => `${NODE}/${name}`)
            : shown(graph.services().filter(({ servers }) => servers.includes(node))),
        };
      },
    };
  }

  /** @returns {Record<string, (request: any) => any>} */
  #aboutTypes() {
    const { values, raw: { types } } = this.#session;
    const described = (/** @type {string} */ type, part = "") =>
      ({ typedefs: typedefs(values, types, typeNamed(values, type + part)) });
    return {
      interfaces: () => ({
        interfaces: once(Object.keys(types).map((name) => (name.includes("/msg/") ? name : name.replace(PARTS, "$1")))).sort(),
      }),
      message_details: ({ type }) => {
        const simple = withoutPackage(type);
        if (simple) return { typedefs: simple };
        // Unlike those of services and actions, an unknown message is not a mistake.
        return values.knows(typeNamed(values, type)) ? described(type) : { typedefs: [] };
      },
      service_request_details: ({ type }) => described(type, "_Request"),
      service_response_details: ({ type }) => described(type, "_Response"),
      service_typedescs: ({ type }) => ({
        typedefs: [...described(type, "_Request").typedefs, ...described(type, "_Response").typedefs],
      }),
      action_goal_details: ({ type }) => described(type, "_Goal"),
      action_result_details: ({ type }) => described(type, "_Result"),
      action_feedback_details: ({ type }) => described(type, "_Feedback"),
    };
  }
}

/**
 * Whether two names of a type, in the spelling of ROS 1 or of ROS 2, are the same.
 * @param {unknown} a @param {unknown} b
 */
function same(a, b) {
  const plain = (/** @type {unknown} */ name) => String(name).replace(/\/(msg|srv|action)\//, "/");
  return plain(a) === plain(b);
}

/** The fields of a request, all of which are texts; those that are missing are empty. @param {any} request */
function textsOf(request) {
  return Object.fromEntries(FIELDS.map((key) => {
    const value = request[key] ?? "";
    if (typeof value !== "string") throw new Mistake(`'${key}' is a ${typeof value}; it must be a string`);
    return [key, value];
  }));
}

/** @param {string[]} [names] */
function once(names = []) {
  return [...new Set(names)];
}
