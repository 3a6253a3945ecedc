# The names of versions before 0.8.
sitegen_named(yaml-cpp yaml-cpp::yaml-cpp)
set(YAML_CPP_LIBRARIES yaml-cpp)
set(YAML_CPP_INCLUDE_DIR "${SITEGEN_SOURCES}/yaml-cpp/include")
