foreach(_name IN ITEMS PNG::PNG png_static)
  sitegen_named(${_name} libpng::png)
endforeach()
