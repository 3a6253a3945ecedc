"""Service servers and clients."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import ros_host
from pyodide.ffi import to_js

from rclpy_backend import cdr, log
from rclpy_backend.clock import Clock
from rclpy_backend.endpoint import Endpoint, gid_bytes
from rclpy_backend.enums import ServiceIntrospectionState
from rclpy_backend.handles import Destroyable
from rclpy_backend.introspection import Introspection, ServiceEvent
from rclpy_backend.qos import rmw_qos_profile_t
from rclpy_backend.received import Received, take

if TYPE_CHECKING:
    from rclpy_backend.node import Node


class rmw_request_id_t:
    """The identity of a request: its sequence number and the gid of its client."""

    def __init__(self, sequence_number: int, writer_gid: int) -> None:
        self.sequence_number = sequence_number
        self.writer_gid = writer_gid


class rmw_service_info_t:
    """The identity and the timestamps of a request or a response."""

    def __init__(self, sample: Received) -> None:
        self.request_id = rmw_request_id_t(sample.sequence, sample.writer_gid)
        self.source_timestamp = sample.source_timestamp
        self.received_timestamp = sample.received_timestamp


class ServiceEndpoint(Endpoint):
    """The common part of servers and clients."""

    def __init__(
        self, kind: str, node: Node, service_type: Any, name: str, profile: rmw_qos_profile_t
    ) -> None:
        super().__init__(kind, node, service_type, name, profile)
        self._type = service_type
        self._introspection: Introspection | None = None

    def configure_introspection(
        self,
        clock: Clock,
        pyqos_service_event_pub: rmw_qos_profile_t,
        introspection_state: int,
    ) -> None:
        """Set what the service publishes about its calls: contents, metadata or nothing."""
        self._end_introspection()
        if introspection_state == ServiceIntrospectionState.OFF:
            return
        self._introspection = Introspection(
            self.node,
            self._type,
            self._full_name,
            clock=clock,
            profile=pyqos_service_event_pub,
            contents=introspection_state == ServiceIntrospectionState.CONTENTS,
        )

    def _tell(self, what: ServiceEvent, gid: bytes, sequence: int, **said: Any) -> None:
        if self._introspection:
            self._introspection.tell(what, gid, sequence, **said)

    def _end_introspection(self) -> None:
        if self._introspection:
            self._introspection.end()
            self._introspection = None

    def _destroy(self) -> None:
        self._end_introspection()
        super()._destroy()

    def _take(self, message_type: type) -> tuple[rmw_service_info_t, Any] | None:
        sample = take(self.id)
        if sample is None:
            return None
        try:
            return rmw_service_info_t(sample), cdr.deserialize(sample.data, message_type)
        except cdr.CdrError as error:
            log.report(f"dropped {len(sample.data)} bytes for '{self._full_name}': {error}")
            return None


class Client(ServiceEndpoint):
    """A service client."""

    def __init__(
        self, node: Node, service_type: Any, service_name: str, profile: rmw_qos_profile_t
    ) -> None:
        super().__init__("client", node, service_type, service_name, profile)

    @property
    def service_name(self) -> str:
        """The full name of the service."""
        return self._full_name

    def service_server_is_available(self) -> bool:
        """Return whether a server is available.

        Raises:
            RCLError: if the context has been shut down.
        """
        self.node.context.check("failed to check service availability")
        return self.matched() > 0

    def send_request(self, request: Any) -> int:
        """Send a request and return its sequence number.

        Raises:
            TypeError: if the request is of another type.
        """
        data = cdr.serialize(request, self._type.Request)
        sequence = int(ros_host.request(self.id, to_js(data)))
        self._tell(ServiceEvent.REQUEST_SENT, self.gid(), sequence, request=request)
        return sequence

    def take_response(
        self, response_type: type
    ) -> tuple[rmw_service_info_t, Any] | tuple[None, None]:
        """Return the oldest response and its identity, or two Nones."""
        taken = self._take(response_type)
        if not taken:
            return None, None
        sequence = taken[0].request_id.sequence_number
        self._tell(ServiceEvent.RESPONSE_RECEIVED, self.gid(), sequence, response=taken[1])
        return taken


class Service(ServiceEndpoint):
    """A service server."""

    def __init__(
        self, node: Node, service_type: Any, name: str, profile: rmw_qos_profile_t
    ) -> None:
        super().__init__("service", node, service_type, name, profile)

    @property
    def name(self) -> str:
        """The full name of the service."""
        return self._full_name

    @property
    def qos(self) -> dict[str, Any]:
        """The QoS policies by name."""
        return self.profile.to_dict()

    def service_take_request(
        self, request_type: type
    ) -> tuple[Any, rmw_service_info_t] | tuple[None, None]:
        """Return the oldest request and its identity, or two Nones."""
        taken = self._take(request_type)
        if not taken:
            return None, None
        info, request = taken
        asked = info.request_id
        gid = gid_bytes(asked.writer_gid)
        self._tell(ServiceEvent.REQUEST_RECEIVED, gid, asked.sequence_number, request=request)
        return request, info

    def service_send_response(
        self, response: Any, header: rmw_service_info_t | rmw_request_id_t
    ) -> None:
        """Send a response.

        Raises:
            TypeError: if the response is of another type.
        """
        request = header.request_id if isinstance(header, rmw_service_info_t) else header
        data = cdr.serialize(response, self._type.Response)
        ros_host.respond(self.id, request.writer_gid, request.sequence_number, to_js(data))
        gid = gid_bytes(request.writer_gid)
        self._tell(ServiceEvent.RESPONSE_SENT, gid, request.sequence_number, response=response)


class TypeDescriptionService(Destroyable):
    """The type description service of a node, which always reports failure."""

    def __init__(self, node: Node) -> None:
        super().__init__()
        from type_description_interfaces.srv import GetTypeDescription

        profile = rmw_qos_profile_t.predefined("qos_profile_services_default")
        self.impl = Service(node, GetTypeDescription, "~/get_type_description", profile)

    def _destroy(self) -> None:
        self.impl.destroy_when_not_in_use()

    def handle_request(self, request: Any, response_type: Any, node: Node) -> Any:
        """Return a response that reports failure."""
        reason = "type descriptions are not available in the browser"
        return response_type(successful=False, failure_reason=reason)
