#pragma once

// Programs are linked statically, so all symbols are visible.
#define URDF_EXPORT
