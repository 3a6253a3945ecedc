sitegen_named(tinyxml2 tinyxml2::tinyxml2)
set(TinyXML2_LIBRARY tinyxml2)
set(TINYXML2_LIBRARY tinyxml2)
set(TINYXML2_INCLUDE_DIR "${SITEGEN_SOURCES}/tinyxml2")
