#pragma once

constexpr double kInch = 0.0254;
