"""A server and a client in one program: asked with a future, and from a thread."""

import threading

import rclpy
from rclpy.executors import SingleThreadedExecutor
from std_srvs.srv import SetBool, Trigger


def main():
    """Ask in all ways."""
    rclpy.init()
    server = rclpy.create_node("server")
    client_node = rclpy.create_node("client")

    def answer(request, response):
        response.success = not request.data
        response.message = f"was {request.data}"
        return response

    async def answer_later(request, response):
        response.message = "from a coroutine"
        return response

    server.create_service(SetBool, "flip", answer)
    server.create_service(Trigger, "later", answer_later)
    executor = SingleThreadedExecutor()
    executor.add_node(server)
    executor.add_node(client_node)

    flip = client_node.create_client(SetBool, "flip")
    nobody = client_node.create_client(Trigger, "nobody")
    print("nobody there:", nobody.wait_for_service(timeout_sec=0.1))
    print("there:", flip.wait_for_service(timeout_sec=10.0))
    for value in (True, False):
        future = flip.call_async(SetBool.Request(data=value))
        executor.spin_until_future_complete(future)
        print(future.result())
    lost = nobody.call_async(Trigger.Request())
    executor.spin_until_future_complete(lost, timeout_sec=0.2)
    print("lost is done:", lost.done())

    thread = threading.Thread(target=executor.spin, daemon=True)
    thread.start()
    later = client_node.create_client(Trigger, "later")
    later.wait_for_service()
    print(later.call(Trigger.Request()))
    print(flip.call(SetBool.Request(data=True)).message)
    executor.shutdown()
    thread.join()
    rclpy.shutdown()
    print("done")
