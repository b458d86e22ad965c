#pragma once
// State of the render thread: context, scenes and targets. Used on that thread only.

#include <map>
#include <memory>

#include "render/look_choice.h"
#include "render/platform/egl_context.h"
#include "render/requests.h"
#include "render/target.h"

namespace trundle {

class RenderThreadState {
public:
    [[nodiscard]] static Result<std::unique_ptr<RenderThreadState>> open();
    ~RenderThreadState();

    void add(SceneId id, std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<const ExperimentSpec> ghosts);
    void remove(SceneId id);
    /// Falls back to the fast look if the rich one is not available.
    [[nodiscard]] Result<Image> draw(const PictureRequest& request, LookChoice look);
    /// Why the rich look is not available; reported once, otherwise empty.
    [[nodiscard]] std::string takeWarning() { return std::exchange(m_notice, {}); }
    [[nodiscard]] Result<DataImage> measure(const PictureRequest& request);
    [[nodiscard]] Result<std::vector<PickResult>> pick(const PickRequest& request);
    /// While `enough` is set, drawing is cancelled and ends with an Error. `enough` must outlive this object.
    void endEarlyOn(bool& enough);
    [[nodiscard]] const EglContext& context() const { return *m_egl; }
    [[nodiscard]] const SceneShading& look() const { return m_shapes->look; }

private:
    struct SceneState {
        std::shared_ptr<const ExperimentSpec> experiment;
        std::unique_ptr<Scene> scene;
        BodyPoses start;
    };
    explicit RenderThreadState(std::unique_ptr<EglContext> egl);
    [[nodiscard]] Result<SceneState*> sceneState(SceneId id, const std::shared_ptr<const BodyPoses>& poses);
    [[nodiscard]] Result<Target*> target(TargetShape shape);
    struct RenderSetup {
        SceneState* sceneState;
        Target* target;
        CameraView view;
    };
    /// Scene, target and view for an image request.
    [[nodiscard]] Result<RenderSetup> prepare(const PictureRequest& request, bool data, bool rich);
    [[nodiscard]] Result<Image> drawOnce(const PictureRequest& request, bool rich);
    /// The sun's shadow map for an image of that size.
    [[nodiscard]] Result<SunMap*> sunMap(std::uint32_t width, std::uint32_t height);
    /// An Error if the driver rejected a program.
    [[nodiscard]] Status programs() const;

    struct CachedTarget {
        std::unique_ptr<Target> target;
        std::uint64_t lastUse = 0;
    };
    std::unique_ptr<EglContext> m_egl;
    osg::ref_ptr<GraphicsContext> m_context;
    std::shared_ptr<ShapeStore> m_shapes;
    std::map<std::uint32_t, std::unique_ptr<SunMap>> m_suns; // by size in pixels
    std::map<SceneId, SceneState> m_sceneStates;
    std::map<TargetShape, CachedTarget> m_targets;
    std::uint64_t m_uses = 0;
    int m_mostSamples = 1;
    bool m_isRichBroken = false; // a program of the rich look was rejected
    bool m_isNoticed = false;
    std::string m_notice;
};

} // namespace trundle
