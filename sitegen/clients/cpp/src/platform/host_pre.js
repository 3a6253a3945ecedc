// Return the function at a C++ function pointer, for WebAssembly.promising.
Module["rosFunction"] = function(pointer) { return wasmTable.get(pointer); };
// Return the file system of the program; only programs that look for files have one.
Module["rosFiles"] = function() { return FS; };
