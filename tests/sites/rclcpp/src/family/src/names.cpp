// Names of the API that published packages use and tutorials do not.
#include <dlfcn.h>
#include <execinfo.h>
#include <linux/limits.h>
#include <malloc.h>
#include <sched.h>
#include <sys/capability.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <execution>
#include <memory>
#include <thread>

#include "class_loader/multi_library_class_loader.hpp"
#include "example_interfaces/srv/set_bool.hpp"
#include "message_filters/subscriber.h"
#include "rclcpp/copy_all_parameter_values.hpp"
#include "rclcpp/parameter_service.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rcpputils/shared_library.hpp"
#include "rclcpp/subscription_traits.hpp"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::String;
using example_interfaces::srv::SetBool;

namespace traits = rclcpp::subscription_traits;
using OfBytes = void (std::shared_ptr<const rclcpp::SerializedMessage>);
static_assert(traits::is_serialized_callback<OfBytes>::value);
static_assert(!traits::is_serialized_callback<void (const String &)>::value);

void set_and_get(rclcpp::Node::SharedPtr node)
{
  auto other = std::make_shared<rclcpp::Node>(
    "other", rclcpp::NodeOptions().start_parameter_services(false));
  other->declare_parameter("speed", 1.5);
  rclcpp::ParameterService service(
    other->get_node_base_interface(), other->get_node_services_interface(),
    other->get_node_parameters_interface().get());

  rclcpp::AsyncParametersClient client(
    node->get_node_base_interface(), node->get_node_topics_interface(),
    node->get_node_graph_interface(), node->get_node_services_interface(), "other",
    rmw_qos_profile_parameters);
  client.wait_for_service(std::chrono::seconds(5));
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.add_node(other);
  auto done = client.set_parameters({rclcpp::Parameter("speed", 2.5)});
  executor.spin_until_future_complete(done);
  std::printf("set %d, speed %.1f\n", done.get()[0].successful, other->get_parameter("speed").as_double());

  executor.remove_node(node);
  std::thread spinning([&] {executor.spin();});
  auto own = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  rclcpp::SyncParametersClient waiting(
    own, node->get_node_base_interface(), node->get_node_topics_interface(),
    node->get_node_graph_interface(), node->get_node_services_interface(), "other");
  std::printf("waited, speed %.1f\n", waiting.get_parameter<double>("speed"));
  executor.cancel();
  spinning.join();

  rclcpp::copy_all_parameter_values(other, node);
  std::printf("copied %.1f\n", node->get_parameter("speed").as_double());
}

void filter(rclcpp::Node::SharedPtr node)
{
  message_filters::Subscriber<String, rclcpp::Node> filter(
    node.get(), "words", rmw_qos_profile_default);
  message_filters::Subscriber<String> newer(node, "words", rclcpp::QoS(10));
  int heard = 0;
  filter.registerCallback([&](const String::ConstSharedPtr &) {++heard;});
  newer.registerCallback([&](const String::ConstSharedPtr &) {++heard;});
  message_filters::SubscriberBase<rclcpp::Node> & base = filter;
  base.unsubscribe();
  base.subscribe();
  auto publisher = node->create_publisher<String>("words", 10);
  publisher->publish(String());
  for (int i = 0; i < 100 && heard < 2; ++i) {
    rclcpp::spin_some(node);
    rclcpp::sleep_for(std::chrono::milliseconds(10));
  }
  std::printf("heard %d\n", heard);
}

/// A request and its response, without an executor.
void take_by_hand(rclcpp::Node::SharedPtr node)
{
  auto service = node->create_service<SetBool>(
    "by_hand", [](SetBool::Request::SharedPtr, SetBool::Response::SharedPtr) {});
  auto client = node->create_client<SetBool>("by_hand");
  client->wait_for_service();
  auto wanted = std::make_shared<SetBool::Request>();
  wanted->data = true;
  const auto sent = client->async_send_request(wanted);
  SetBool::Request request;
  SetBool::Response response;
  rmw_request_id_t asked, answered;
  while (!service->take_request(request, asked)) {rclcpp::sleep_for(std::chrono::milliseconds(1));}
  response.message = "by hand";
  service->send_response(asked, response);
  response.message.clear();
  while (!client->take_response(response, answered)) {
    rclcpp::sleep_for(std::chrono::milliseconds(1));
  }
  std::printf(
    "took %d, %s, the same %d\n", request.data, response.message.c_str(),
    answered.sequence_number == sent.request_id);
}

void time(rclcpp::Node::SharedPtr node)
{
  rclcpp::Clock steady(RCL_STEADY_TIME), copy;
  copy = steady;
  const rclcpp::Time long_after = copy.now() + rclcpp::Duration(std::chrono::hours(1));
  bool awake = false;
  std::thread other([&] {
      for (; !awake; rclcpp::sleep_for(std::chrono::milliseconds(1))) {copy.cancel_sleep_or_wait();}
    });
  std::printf("slept %d\n", steady.sleep_until(long_after));
  awake = true;
  other.join();
  auto timer = node->create_wall_timer(std::chrono::hours(1), [] {});
  timer->reset();
  timer->reset();
  timer->set_on_reset_callback([](std::size_t number) {std::printf("reset %zu\n", number);});
  timer->reset();
  rclcpp::GenericRate<std::chrono::steady_clock> rate(1000.0);
  std::printf("steady %d, on time %d\n", rate.is_steady(), rate.sleep());
  std::printf("overflows %d\n", rclcpp::add_will_overflow<std::int64_t>(INT64_MAX, 1));
  auto context = node->get_node_base_interface()->get_context();
  ++*context->get_sub_context<int>(2);
  std::printf("in the context %d\n", *context->get_sub_context<int>(2));
}

/// What g++ and glibc have, and the compiler of a page lacks.
void of_linux()
{
  const bool set = mallopt(M_TRIM_THRESHOLD, -1) && mallopt(M_MMAP_MAX, 0) && mallopt(M_ARENA_MAX, 1);
  std::printf("malloc %d %d %d\n", set, malloc_trim(0), mallinfo2().uordblks > 0);
  std::printf("tid %d, other %ld\n", syscall(SYS_gettid) == gettid(), syscall(-1));
  void * callers[4];
  char ** symbols = backtrace_symbols(callers, backtrace(callers, 4));
  std::printf("backtrace %d, path %d\n", symbols != nullptr, PATH_MAX);
  std::free(symbols);

  std::vector<int> numbers{3, 1, 2}, doubled(3);
  std::sort(std::execution::par, numbers.begin(), numbers.end());
  std::transform(
    std::execution::par_unseq, numbers.begin(), numbers.end(), doubled.begin(),
    [](int number) {return 2 * number;});
  std::for_each(std::execution::seq, doubled.begin(), doubled.end(), [](int & each) {++each;});
  std::printf(
    "parallel %d %d, sum %d\n", numbers[0], doubled[2],
    std::reduce(std::execution::par, doubled.begin(), doubled.end()));
}

template<class CallT>
void refused(const char * name, CallT call)
{
  errno = 0;
  const int result = call();
  std::printf("%s %d%s\n", name, result, errno == EPERM ? " EPERM" : "");
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("names");
  set_and_get(node);
  filter(node);
  take_by_hand(node);
  time(node);
  of_linux();
  sched_param parameters{};
  parameters.sched_priority = 80;
  refused("sched_setscheduler", [&] {return sched_setscheduler(0, SCHED_FIFO, &parameters);});
  refused("mlockall", [] {return mlockall(MCL_CURRENT);});
  refused("setpriority", [] {return setpriority(PRIO_PROCESS, 0, -5);});
  const cap_t capabilities = cap_get_proc();
  refused("cap_set_proc", [=] {return cap_set_proc(capabilities);});
  std::printf(
    "thread %d\n", pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == EPERM);
  pthread_attr_t attributes;
  std::printf(
    "attributes %d %d %d\n", pthread_getattr_default_np(&attributes),
    pthread_attr_setscope(&attributes, PTHREAD_SCOPE_SYSTEM),
    pthread_setattr_default_np(&attributes));
  std::printf("opened %d: %s\n", dlopen("libother.so", RTLD_NOW) != nullptr, dlerror());
  try {
    rcpputils::SharedLibrary library("libother.so");
  } catch (const std::runtime_error &) {
    std::puts("library refused");
  }
  try {
    class_loader::MultiLibraryClassLoader(false).createInstance<int>("missing");
  } catch (const class_loader::CreateClassException & error) {
    std::puts(error.what());
  }
  rclcpp::shutdown();
}
