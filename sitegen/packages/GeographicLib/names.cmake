foreach(_name IN ITEMS GeographicLib GeographicLib_SHARED GeographicLib_STATIC
    GeographicLib::GeographicLib_SHARED GeographicLib::GeographicLib_STATIC)
  sitegen_named(${_name} GeographicLib::GeographicLib)
endforeach()
set(GeographicLib_SHARED_LIBRARIES GeographicLib)
set(GeographicLib_STATIC_LIBRARIES GeographicLib)
set(GEOGRAPHICLIB_DATA "/usr/share/GeographicLib")
