sitegen_named(ZLIB::ZLIB zlib::z)
