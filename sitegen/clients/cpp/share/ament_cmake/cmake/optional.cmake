# Libraries that programs load by the names of their classes. Where one needs what no page can have,
# sitegen configures the package again, with its target in SITEGEN_LEFT_OUT.
include_guard(GLOBAL)

# Keep all of the library `target`. The result is FALSE if it is left out.
function(sitegen_keep_optional target result)
  set_property(GLOBAL APPEND PROPERTY SITEGEN_OPTIONAL ${target})
  set(${result} TRUE PARENT_SCOPE)
  if(target IN_LIST SITEGEN_LEFT_OUT)
    set(${result} FALSE PARENT_SCOPE)
  else()
    sitegen_keep(${target})
  endif()
endfunction()

# Write the targets of these libraries to a file, one in each line.
function(sitegen_write_optional)
  get_property(targets GLOBAL PROPERTY SITEGEN_OPTIONAL)
  list(REMOVE_DUPLICATES targets)
  list(JOIN targets "\n" text)
  file(WRITE "${CMAKE_BINARY_DIR}/optional.txt" "${text}")
endfunction()
