#pragma once

// Programs are linked statically, so all symbols are visible.
#define MESSAGE_FILTERS_EXPORT
#define MESSAGE_FILTERS_IMPORT
#define MESSAGE_FILTERS_PUBLIC
#define MESSAGE_FILTERS_LOCAL
