// The host functions of include/rclcpp/detail/host.h: each call is forwarded to Module.ros, the
// worker's host object (runtime/workers/cpp/cppHost.js), with the memory views that it needs.
mergeInto(LibraryManager.library, {
  ros_create: function(kind, node, name, type, qos) {
    return Module["ros"]["create"](HEAPU8, kind, node, name, type, qos);
  },
  ros_destroy: function(id) { Module["ros"]["destroy"](id); },
  ros_gid: function(id) { return Module["ros"]["name"](id); },
  ros_publish: function(id, data, size) { return Module["ros"]["publish"](HEAPU8, id, data, size); },
  ros_filter: function(id, definition, expression, parameters, count, problem, capacity) {
    return Module["ros"]["filter"](
      HEAPU8, id, definition, expression, parameters, count, problem, capacity);
  },
  ros_behind: function(id) { return Module["ros"]["behind"](id); },
  ros_assert: function(id) { Module["ros"]["assert"](id); },
  ros_events: function() { return Module["ros"]["events"](); },
  ros_take_event: function(id, kind, event) {
    return Module["ros"]["takeEvent"](HEAPU8, id, kind, event);
  },
  ros_request: function(id, data, size) { return Module["ros"]["request"](HEAPU8, id, data, size); },
  ros_respond: function(id, client, sequence, data, size) {
    Module["ros"]["respond"](HEAPU8, id, client, sequence, data, size);
  },
  ros_matched: function(id) { return Module["ros"]["matched"](id); },
  ros_next: function(id, info) { return Module["ros"]["next"](HEAPU8, id, info); },
  ros_take: function(id, to) { Module["ros"]["take"](HEAPU8, id, to); },
  ros_changes: function() { return Module["ros"]["changes"](); },
  ros_look: function() { return Module["ros"]["look"](); },
  ros_read: function(to) { Module["ros"]["read"](HEAPU8, to); },
#if ASYNCIFY
  ros_wait: function(milliseconds) {
    return Asyncify.handleSleep(function(wake) {
      Module["ros"]["wait"](milliseconds).then(wake).catch(Module["ros"]["ended"]);
    });
  },
  ros_wait__async: true,
#else
  ros_wait: function(milliseconds) { return Module["ros"]["wait"](milliseconds); },
  // The compiler need not support JSPI: the import is wrapped here.
  ros_wait__postset: '_ros_wait = new WebAssembly.Suspending(_ros_wait);',
  ros_spawn: function(entry, argument) {
    var run = WebAssembly.promising(wasmTable.get(entry));
    queueMicrotask(function() { run(argument).catch(Module["ros"]["ended"]); });
  },
  ros_swap: function(from, to, entry) {
    return new Promise(function(resolve) {
      rosFibers.set(from, resolve);
      if (entry) return _ros_spawn(entry, to);
      var resume = rosFibers.get(to);
      rosFibers.delete(to);
      resume();
    });
  },
  ros_swap__deps: ['ros_spawn', '$rosFibers'],
  ros_swap__postset: '_ros_swap = new WebAssembly.Suspending(_ros_swap);',
  $rosFibers: 'new Map()', // what resumes each fiber that switched to another, by its address
  // Libraries ask this before they use fibers, which JSPI replaces.
  emscripten_has_asyncify: function() { return 1; },
#endif
  ros_wait__sig: 'id',
  ros_wake: function() { Module["ros"]["wake"](); },
  ros_reading: function(keyboard) {
    // Print a question that has no end of line.
    [FS.streams[1], FS.streams[2]].forEach(function(stream) {
      if (stream.tty.output && stream.tty.output.length) stream.tty.ops.put_char(stream.tty, 10);
    });
    Module["ros"]["reading"](keyboard);
  },
  ros_reading__deps: ['$FS'],
  ros_typed: function() { return Module["ros"]["typed"](); },
  ros_take_typed: function(to, capacity) { return Module["ros"]["takeTyped"](HEAPU8, to, capacity); },
  ros_open: function(folder, path, truncated) {
    var node;
    try {
      node = FS.lookupPath(SYSCALLS.calculateAt(folder, UTF8ToString(path)), { follow: true }).node;
    } catch (error) {
      return 0; // open() says what is wrong
    }
    return Module["ros"]["open"](node, truncated);
  },
  ros_open__deps: ['$FS', '$SYSCALLS'],
  ros_now: function() { return Module["ros"]["now"](); },
  ros_log: function(severity, logger, text, stamp) {
    Module["ros"]["log"](HEAPU8, severity, logger, text, stamp);
  },
  ros_argument: function(index, to, capacity) {
    return Module["ros"]["argument"](HEAPU8, index, to, capacity);
  },
  ros_fail: function(text) { Module["ros"]["fail"](HEAPU8, text); },
  ros_thrown: function(exception) { Module["ros"]["thrown"](exception); },
  ros_blame: function(exception) { Module["ros"]["blame"](exception); },
});
