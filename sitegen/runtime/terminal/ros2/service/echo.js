// @ts-check
// ros2 service echo: the requests and responses of a service, if its node or its clients publish them.

import { Failure } from "../../shell/shell.js";
import { Echo, FORM_OPTIONS } from "../topic/echo.js";
import { absolute, endpoints, flag, fullType, isType } from "../verb.js";

/** @import { Verb } from "../verb.js" */

/** By the numbers of service_msgs/msg/ServiceEventInfo. */
const EVENTS = ["REQUEST_SENT", "REQUEST_RECEIVED", "RESPONSE_SENT", "RESPONSE_RECEIVED"];
const EVENT_TYPE = /^(\s*|\{info: \{)event_type: (\d+)/m;

/** @type {Verb} */
export const echoEvents = {
  name: "echo",
  about: "Echo a service",
  args: [
    { name: "service_name", help: "Name of the ROS service to echo (e.g. '/add_two_ints')", complete: "service" },
    { name: "service_type", count: "?", help: "Type of the ROS service (e.g. 'example_interfaces/srv/AddTwoInts')", complete: "serviceType" },
    flag("csv", ["--csv"], "Output all recursive fields separated by commas (e.g. for plotting)."),
    ...FORM_OPTIONS,
  ],
  async run(io, args) {
    const { service_name: name, service_type: given } = args;
    const { ros, out } = io;
    const known = ros.graph.services().find((one) => one.name === absolute(name))?.types[0];
    const service = given === undefined ? known : fullType(given, "srv");
    if (service === undefined) throw new Failure("Could not load the type for the passed service");
    if (!isType(ros, `${service}_Request`)) throw new Failure(`The service type '${service}' is invalid`);
    const topic = `${absolute(name)}/_service_event`;
    const [publisher] = endpoints(ros, { kind: "publisher", name: topic });
    if (!publisher) await out(`No publishers on topic '${name}/_service_event'; is service introspection on the client or server enabled?\n`);
    const type = publisher?.type ?? `${service}_Event`;
    const named = (/** @type {string} */ text) => text.replace(EVENT_TYPE, (_, before, number) => `${before}event_type: ${EVENTS[number] ?? number}`);
    await new Echo(io, { ...args, qos_profile: "services_default" }, { topic, type, named }).run();
  },
};
