#pragma once

// Programs are linked statically, so all symbols are visible.
#define TF2_PUBLIC
#define TF2_LOCAL
