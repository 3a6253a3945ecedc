foreach(_name IN ITEMS GraphicsMagick GraphicsMagick++)
  sitegen_named(${_name} graphicsmagick::GraphicsMagick)
endforeach()
