// Return the function at a C++ function pointer, for WebAssembly.promising.
Module["rosFunction"] = function(pointer) { return wasmTable.get(pointer); };
