#pragma once
#include <memory>

#include <QImage>

#include "scene/queries/camera_view.h"
#include "scene/queries/object_index.h"

namespace trundle {

/// An image of a view with the camera and poses that it was drawn for.
struct RenderedImage {
    QImage image; ///< null until the first one arrives
    CameraView camera;
    std::shared_ptr<const ObjectIndex> objects;
    std::shared_ptr<const BodyPoses> poses;
};

} // namespace trundle
