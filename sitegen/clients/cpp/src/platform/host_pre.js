// Where a function that C++ points to can be found: WebAssembly.promising needs the function itself.
Module["rosFunction"] = function(pointer) { return wasmTable.get(pointer); };
