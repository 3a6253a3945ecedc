#pragma once

// Programs are linked statically, so all symbols are visible.
#define RCPPUTILS_EXPORT
#define RCPPUTILS_IMPORT
#define RCPPUTILS_PUBLIC
#define RCPPUTILS_LOCAL
