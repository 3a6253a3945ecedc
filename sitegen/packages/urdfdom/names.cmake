# Upstream has several libraries, with and without a namespace.
foreach(_name IN ITEMS urdf_parser urdfdom_model urdfdom_model_state urdfdom_sensor urdfdom_world)
  sitegen_named(${_name} urdfdom::urdfdom)
  sitegen_named(urdfdom::${_name} urdfdom::urdfdom)
endforeach()
