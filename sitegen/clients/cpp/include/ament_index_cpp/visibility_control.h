#pragma once

// Programs are linked statically, so all symbols are visible.
#define AMENT_INDEX_CPP_EXPORT
#define AMENT_INDEX_CPP_IMPORT
#define AMENT_INDEX_CPP_PUBLIC
#define AMENT_INDEX_CPP_LOCAL
