// Pointers to models, and the version of urdfdom_headers.
#pragma once

#include <memory>

#include "urdf_model/types.h"
#include "urdf_world/types.h"

// Later versions have not changed what programs use.
#define URDFDOM_HEADERS_MAJOR_VERSION 1
#define URDFDOM_HEADERS_MINOR_VERSION 0
#define URDFDOM_HEADERS_REVISION_VERSION 0

namespace urdf
{

class Model;
using ModelSharedPtr = std::shared_ptr<Model>;
using ModelConstSharedPtr = std::shared_ptr<const Model>;
using ModelWeakPtr = std::weak_ptr<Model>;

using ModelInterfaceSharedPtr = std::shared_ptr<ModelInterface>;
using ModelInterfaceConstSharedPtr = std::shared_ptr<const ModelInterface>;
using ModelInterfaceWeakPtr = std::weak_ptr<ModelInterface>;

}  // namespace urdf
