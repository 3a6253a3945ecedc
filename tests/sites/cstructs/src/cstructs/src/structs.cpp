// Messages as C structs beside the same messages as C++ classes. Prints what is wrong, and "done".
#include "cstructs/action/drive.h"
#include "cstructs/msg/route.h"
#include "cstructs/srv/plan.h"
#include "example_interfaces/srv/add_two_ints.h"
#include "geometry_msgs/msg/pose_with_covariance_stamped.h"
#include "std_srvs/srv/detail/trigger__functions.h"
#include "std_srvs/srv/detail/trigger__type_support.h"
#include "std_srvs/srv/trigger.h"
#include "test_msgs/action/fibonacci.h"
#include "test_msgs/msg/arrays.h"
#include "test_msgs/msg/bounded_sequences.h"
#include "test_msgs/msg/multi_nested.h"
#include "test_msgs/msg/unbounded_sequences.h"
#include "test_msgs/msg/w_strings.h"

#include <cstdio>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "cstructs/msg/route.hpp"
#include "cstructs/srv/plan.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp/serialization.hpp"
#include "rmw/rmw.h"
#include "stops.h"
#include "test_msgs/msg/arrays.hpp"
#include "test_msgs/msg/bounded_sequences.hpp"
#include "test_msgs/msg/multi_nested.hpp"
#include "test_msgs/msg/unbounded_sequences.hpp"
#include "test_msgs/msg/w_strings.hpp"

#define CHECK(what) if (!(what)) {std::printf("line %d: %s\n", __LINE__, #what);}

namespace
{

using Bytes = std::vector<std::uint8_t>;
using Support = const rosidl_message_type_support_t *;

Bytes bytes_of(Support support, const void * message)
{
  rclcpp::SerializedMessage bytes;
  rclcpp::SerializationBase(support).serialize_message(message, &bytes);
  const auto & raw = bytes.get_rcl_serialized_message();
  return {raw.buffer, raw.buffer + raw.buffer_length};
}

template<class Message>
Support in_cpp() {return rosidl_typesupport_cpp::get_message_type_support_handle<Message>();}

bool read(Support support, Bytes & bytes, void * message)
{
  rmw_serialized_message_t raw = rmw_get_zero_initialized_serialized_message();
  raw.buffer = bytes.data();
  raw.buffer_length = raw.buffer_capacity = bytes.size();
  return rmw_deserialize(&raw, support, message) == RMW_RET_OK;
}

// A new struct holds what a new C++ message holds; each reads what the other wrote.
#define CHECK_TWINS(pkg, Name) \
  { \
    const auto c = ROSIDL_GET_MSG_TYPE_SUPPORT(pkg, msg, Name); \
    const auto cpp = in_cpp<pkg::msg::Name>(); \
    pkg::msg::Name twin; \
    auto * message = pkg ## __msg__ ## Name ## __create(); \
    auto * other = pkg ## __msg__ ## Name ## __create(); \
    Bytes bytes = bytes_of(cpp, &twin); \
    CHECK(bytes_of(c, message) == bytes); \
    CHECK(read(c, bytes, other) && bytes_of(c, other) == bytes); \
    CHECK((pkg ## __msg__ ## Name ## __are_equal(message, other))); \
    pkg ## __msg__ ## Name ## __destroy(message); \
    pkg ## __msg__ ## Name ## __destroy(other); \
  }

void check_strings()
{
  rosidl_runtime_c__String text;
  CHECK(rosidl_runtime_c__String__init(&text) && text.size == 0 && text.capacity == 1);
  CHECK(text.data[0] == 0);
  CHECK(rosidl_runtime_c__String__assignn(&text, "abcdef", 3));
  CHECK(text.size == 3 && text.capacity == 4 && !std::strcmp(text.data, "abc"));
  CHECK(!rosidl_runtime_c__String__assign(&text, nullptr));
  CHECK(!rosidl_runtime_c__String__assign(nullptr, "a"));
  CHECK(!rosidl_runtime_c__String__assignn(&text, "a", std::numeric_limits<size_t>::max()));
  CHECK(!rosidl_runtime_c__String__are_equal(&text, nullptr));
  CHECK(!std::strcmp(text.data, "abc"));
  rosidl_runtime_c__String__Sequence some, others;
  CHECK(rosidl_runtime_c__String__Sequence__init(&some, 2) && some.capacity == 2);
  CHECK(rosidl_runtime_c__String__Sequence__init(&others, 0) && !others.data);
  CHECK(rosidl_runtime_c__String__copy(&text, &some.data[1]));
  CHECK(!rosidl_runtime_c__String__Sequence__are_equal(&some, &others));
  CHECK(rosidl_runtime_c__String__Sequence__copy(&some, &others));
  CHECK(rosidl_runtime_c__String__Sequence__are_equal(&some, &others));
  CHECK(some.data[1].data != others.data[1].data);
  others.data[1].data[0] = 'x';
  CHECK(!rosidl_runtime_c__String__Sequence__are_equal(&some, &others));
  rosidl_runtime_c__String__Sequence__fini(&some);
  CHECK(!some.data && !some.size && !some.capacity);
  rosidl_runtime_c__String__Sequence__fini(&some);
  CHECK(rosidl_runtime_c__String__Sequence__copy(&some, &others));
  CHECK(others.size == 0 && others.capacity == 2);  // room is kept
  rosidl_runtime_c__String__Sequence__fini(&others);
  rosidl_runtime_c__String__fini(&text);
  CHECK(!text.data && !text.capacity);

  rosidl_runtime_c__U16String wide;
  const uint16_t units[] = {'a', 0x3042, 0};
  CHECK(rosidl_runtime_c__U16String__init(&wide));
  CHECK(rosidl_runtime_c__U16String__assign(&wide, units) && wide.size == 2 && wide.data[2] == 0);
  CHECK(rosidl_runtime_c__U16String__resize(&wide, 1) && wide.data[1] == 0);
  CHECK(!rosidl_runtime_c__U16String__assignn_from_char(&wide, "abc", 3));
  rosidl_runtime_c__U16String__fini(&wide);
}

void check_sequences()
{
  rosidl_runtime_c__double__Sequence some, others;
  CHECK(!rosidl_runtime_c__double__Sequence__init(nullptr, 1));
  CHECK(rosidl_runtime_c__double__Sequence__init(&some, 2) && some.data[1] == 0);
  CHECK(rosidl_runtime_c__double__Sequence__init(&others, 3));
  some.data[0] = 0.5;
  CHECK(!rosidl_runtime_c__double__Sequence__are_equal(&some, &others));
  CHECK(rosidl_runtime_c__double__Sequence__copy(&some, &others));
  CHECK(others.size == 2 && others.capacity == 3 && others.data[0] == 0.5);
  CHECK(rosidl_runtime_c__double__Sequence__are_equal(&some, &others));
  some.data[1] = others.data[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(!rosidl_runtime_c__double__Sequence__are_equal(&some, &others));
  rosidl_runtime_c__double__Sequence__fini(&some);
  rosidl_runtime_c__double__Sequence__fini(&others);
}

void check_defaults()
{
  cstructs__msg__Stop stop;
  CHECK(cstructs__msg__Stop__init(&stop));
  CHECK(cstructs__msg__Stop__LEAST == std::numeric_limits<std::int64_t>::min());
  CHECK(cstructs__msg__Stop__LATE == cstructs::msg::Stop::LATE);
  CHECK(cstructs__msg__Stop__HALF == cstructs::msg::Stop::HALF);
  CHECK(cstructs__msg__Stop__GREETING == cstructs::msg::Stop::GREETING);
  CHECK(cstructs__msg__Stop__lines__MAX_SIZE == 3);
  CHECK(cstructs__msg__Route__code__MAX_STRING_SIZE == 5);
  CHECK(cstructs__srv__Plan_Request__FAST == cstructs::srv::Plan::Request::FAST);
  CHECK(stop.name.data == std::string("Görlitz"));
  CHECK(stop.sign.size == 6 && stop.sign.data[1] == 0xfc);
  CHECK(stop.place[1] == -2.5 && stop.tracks.size == 3 && stop.tracks.data[2] == 3);
  CHECK(stop.lines.size == 2 && stop.lines.data[1].data == std::string("S2"));
  cstructs__msg__Stop__fini(&stop);
  CHECK(!stop.name.data && !stop.lines.data);
}

// A filled struct has the bytes of a C++ message filled alike.
Bytes check_route()
{
  cstructs::msg::Route twin;
  auto * route = cstructs__msg__Route__create();
  CHECK(add_stop(route, "Bautzen") && add_stop(route, "Zittau"));
  twin.stops.resize(2);
  twin.stops[0].name = "Bautzen";
  twin.stops[1].name = "Zittau";
  CHECK(geometry_msgs__msg__Pose__Sequence__init(&route->poses, 1));
  twin.poses.resize(1);
  route->poses.data[0].position.x = twin.poses[0].position.x = 4.25;
  CHECK(route->poses.data[0].orientation.w == 1);  // a default value in a nested message
  CHECK(rosidl_runtime_c__boolean__Sequence__init(&route->flags, 3));
  route->flags.data[1] = true;
  twin.flags = {false, true, false};
  CHECK(rosidl_runtime_c__U16String__Sequence__init(&route->signs, 1));
  const uint16_t units[] = {0x3042};
  CHECK(rosidl_runtime_c__U16String__assignn(&route->signs.data[0], units, 1));
  twin.signs = {u"\u3042"};
  CHECK(rosidl_runtime_c__String__assign(&route->code, "ab"));
  twin.code = "ab";

  const auto c = ROSIDL_GET_MSG_TYPE_SUPPORT(cstructs, msg, Route);
  Bytes bytes = bytes_of(c, route);
  CHECK(bytes == bytes_of(in_cpp<cstructs::msg::Route>(), &twin));
  CHECK(bytes_of(route_in_c(), route) == bytes);

  // It is read into a struct that holds something already.
  auto * other = cstructs__msg__Route__create();
  CHECK(add_stop(other, "Löbau") && !cstructs__msg__Route__are_equal(route, other));
  CHECK(read(c, bytes, other) && cstructs__msg__Route__are_equal(route, other));
  other->ends[1].place[0] = 0;
  CHECK(!cstructs__msg__Route__are_equal(route, other));
  CHECK(cstructs__msg__Route__copy(route, other) && cstructs__msg__Route__are_equal(route, other));
  CHECK(other->stops.data[1].name.data != route->stops.data[1].name.data);
  CHECK(!cstructs__msg__Route__copy(route, nullptr) && !cstructs__msg__Route__init(nullptr));

  // Wrong lengths are refused before any memory is allocated for them.
  for (const std::size_t size : {std::size_t(3), std::size_t(9), bytes.size() - 1}) {
    Bytes cut(bytes.begin(), bytes.begin() + size);
    CHECK(!read(c, cut, other));
  }
  Bytes wrong = bytes;
  wrong[7] = 0x7f;
  CHECK(!read(c, wrong, other));
  CHECK(rosidl_runtime_c__String__assign(&other->code, "too long"));
  bool thrown = false;
  try {
    bytes_of(c, other);
  } catch (const std::length_error &) {
    thrown = true;
  }
  CHECK(thrown);
  cstructs__msg__Route__destroy(other);
  cstructs__msg__Route__destroy(route);
  return bytes;
}

void check_type_supports()
{
  const auto c = ROSIDL_GET_MSG_TYPE_SUPPORT(geometry_msgs, msg, Pose);
  const auto & members = *static_cast<const rosidl_typesupport_sitegen_cpp::MessageMembers *>(c->data);
  CHECK(members.name == std::string("geometry_msgs/msg/Pose"));
  rosidl_type_hash_t hash;
  CHECK(rosidl_parse_type_hash_string(members.hash, &hash) == RCUTILS_RET_OK);
  CHECK(!std::memcmp(c->get_type_hash_func(c), &hash, sizeof(hash)));
  CHECK(rosidl_parse_type_hash_string("RIHS01_12", &hash) != RCUTILS_RET_OK);
  char * text = nullptr;
  CHECK(rosidl_stringify_type_hash(c->get_type_hash_func(c), rcutils_get_default_allocator(), &text) ==
    RCUTILS_RET_OK && !std::strcmp(text, members.hash));
  std::free(text);
  CHECK(c->get_type_description_func(c)->type_description.fields.size == 0);
  CHECK(c->get_type_description_sources_func(c)->size == 0);
  CHECK(get_message_typesupport_handle(c, c->typesupport_identifier) == c);
  CHECK(!get_message_typesupport_handle(c, "another"));

  const auto plan = ROSIDL_GET_SRV_TYPE_SUPPORT(cstructs, srv, Plan);
  cstructs::srv::Plan::Request request;
  auto * twin = cstructs__srv__Plan_Request__create();
  CHECK(bytes_of(plan->request_typesupport, twin) ==
    bytes_of(in_cpp<cstructs::srv::Plan::Request>(), &request));
  rosidl_service_introspection_info_t info = {2, 3, 4, {5}, 6};
  rcutils_allocator_t allocator = rcutils_get_default_allocator();
  auto * event = static_cast<cstructs__srv__Plan_Event *>(
    plan->event_message_create_handle_function(&info, &allocator, twin, nullptr));
  CHECK(event && event->info.stamp.nanosec == 4 && event->info.client_gid[0] == 5);
  CHECK(event && event->request.size == 1 && event->response.size == 0);
  CHECK(cstructs__srv__Plan_Request__are_equal(&event->request.data[0], twin));
  CHECK(plan->event_message_destroy_handle_function(event, &allocator));
  cstructs__srv__Plan_Request__destroy(twin);

  const auto drive = ROSIDL_GET_ACTION_TYPE_SUPPORT(cstructs, Drive);
  CHECK(drive->goal_service_type_support->request_typesupport);
  CHECK(std::memcmp(drive->get_type_hash_func(drive),
    drive->goal_service_type_support->get_type_hash_func(drive->goal_service_type_support),
    sizeof(hash)));
  CHECK(ROSIDL_GET_SRV_TYPE_SUPPORT(std_srvs, srv, Trigger)->response_typesupport->data);
  auto * sum = example_interfaces__srv__AddTwoInts_Request__create();
  sum->a = sum->b = 7;
  CHECK(sum->a + sum->b == 14);
  example_interfaces__srv__AddTwoInts_Request__destroy(sum);
  auto * goal = test_msgs__action__Fibonacci_SendGoal_Request__create();
  CHECK(goal && goal->goal.order == 0);
  test_msgs__action__Fibonacci_SendGoal_Request__destroy(goal);
}

}  // namespace

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  check_strings();
  check_sequences();
  check_defaults();
  check_type_supports();
  CHECK_TWINS(geometry_msgs, PoseWithCovarianceStamped);
  CHECK_TWINS(test_msgs, Arrays);
  CHECK_TWINS(test_msgs, BoundedSequences);
  CHECK_TWINS(test_msgs, UnboundedSequences);
  CHECK_TWINS(test_msgs, MultiNested);
  CHECK_TWINS(test_msgs, WStrings);
  const Bytes bytes = check_route();

  // What another node hears of a struct.
  auto node = std::make_shared<rclcpp::Node>("structs");
  auto publisher = node->create_generic_publisher("route", "cstructs/msg/Route", rclcpp::QoS(1));
  auto subscription = node->create_subscription<cstructs::msg::Route>(
    "route", 1, [](const cstructs::msg::Route & route) {
      std::printf("heard %s\n", route.stops.at(1).name.c_str());
      std::puts("done");
      rclcpp::shutdown();
    });
  rclcpp::SerializedMessage message(bytes.size());
  auto & raw = message.get_rcl_serialized_message();
  std::memcpy(raw.buffer, bytes.data(), bytes.size());
  raw.buffer_length = bytes.size();
  publisher->publish(message);
  rclcpp::spin(node);
  return 0;
}
