#pragma once

// Programs are linked statically, so all symbols are visible.
#define CLASS_LOADER_EXPORT
#define CLASS_LOADER_IMPORT
#define CLASS_LOADER_PUBLIC
#define CLASS_LOADER_LOCAL
