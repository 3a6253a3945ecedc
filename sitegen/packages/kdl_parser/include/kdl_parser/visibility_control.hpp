#pragma once

// Programs are linked statically, so all symbols are visible.
#define KDL_PARSER_PUBLIC
