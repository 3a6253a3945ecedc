#pragma once

namespace robot_base
{
int wheels();
}
