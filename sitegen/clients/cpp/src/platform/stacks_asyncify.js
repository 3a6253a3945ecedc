// Leave the stack's pointer where it is once the stack has overflowed: cppNode.js looks at it. The
// functions of Emscripten that catch exceptions would reset it on the way of any error.
Module["onRuntimeInitialized"] = function() {
  stackRestore(stackSave()); // Emscripten replaces the function when it is first called
  var restore = stackRestore;
  stackRestore = function(top) { if (stackSave() >= 0) restore(top); };
};
