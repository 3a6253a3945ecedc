sitegen_named(orocos-kdl orocos_kdl::orocos-kdl)
