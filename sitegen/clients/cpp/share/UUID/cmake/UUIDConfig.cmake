# libuuid is a part of Emscripten.
if(NOT TARGET UUID::UUID)
  add_library(UUID::UUID INTERFACE IMPORTED GLOBAL)
  set_target_properties(UUID::UUID PROPERTIES INTERFACE_LINK_LIBRARIES -luuid)
endif()
set(UUID_LIBRARIES -luuid)
set(UUID_LIBRARY -luuid)
