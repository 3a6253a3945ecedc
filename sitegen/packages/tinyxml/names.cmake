sitegen_named(tinyxml tinyxml::tinyxml)
set(TinyXML_LIBRARY tinyxml)
set(TINYXML_LIBRARY tinyxml)
set(TINYXML_INCLUDE_DIR "${SITEGEN_SOURCES}/tinyxml")
