#pragma once
// What the service's thread works with: the context, the scenes, the targets. One thread only.

#include <map>
#include <memory>

#include "render/platform/egl_context.h"
#include "render/service.h"
#include "render/target.h"

namespace trundle {

class Studio {
public:
    [[nodiscard]] static Result<std::unique_ptr<Studio>> open();
    ~Studio();

    void add(SceneId id, std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<const ExperimentSpec> ghosts);
    void remove(SceneId id);
    /// Where the rich look is not to be had the picture has the fast one.
    [[nodiscard]] Result<Image> draw(const PictureRequest& request, LookChoice look);
    /// Why the rich look was not to be had, once; else empty.
    [[nodiscard]] std::string takeNotice() { return std::exchange(m_notice, {}); }
    [[nodiscard]] Result<Measured> measure(const PictureRequest& request);
    [[nodiscard]] Result<std::vector<Picked>> pick(const PickRequest& request);
    /// A picture that is drawn while `enough` is set, or becomes so, ends with an Error. It outlives this.
    void endEarlyOn(bool& enough);
    [[nodiscard]] const EglContext& context() const { return *m_egl; }
    [[nodiscard]] const Look& look() const { return m_shapes->look; }

private:
    struct Stage {
        std::shared_ptr<const ExperimentSpec> experiment;
        std::unique_ptr<Scene> scene;
        BodyPoses start;
    };
    explicit Studio(std::unique_ptr<EglContext> egl);
    [[nodiscard]] Result<Stage*> stage(SceneId id, const std::shared_ptr<const BodyPoses>& poses);
    [[nodiscard]] Result<Target*> target(TargetShape shape);
    struct Set {
        Stage* stage;
        Target* target;
        CameraView view;
    };
    /// Everything in place for a picture.
    [[nodiscard]] Result<Set> prepare(const PictureRequest& request, bool data, bool rich);
    [[nodiscard]] Result<Image> drawOnce(const PictureRequest& request, bool rich);
    /// For a picture of that size.
    [[nodiscard]] Result<SunMap*> sunMap(std::uint32_t width, std::uint32_t height);
    /// An Error where the driver does not take a program.
    [[nodiscard]] Status programs() const;

    struct Kept {
        std::unique_ptr<Target> target;
        std::uint64_t lastUse = 0;
    };
    std::unique_ptr<EglContext> m_egl;
    osg::ref_ptr<GraphicsContext> m_context;
    std::shared_ptr<ShapeStore> m_shapes;
    std::map<std::uint32_t, std::unique_ptr<SunMap>> m_suns; // by their pixels
    std::map<SceneId, Stage> m_stages;
    std::map<TargetShape, Kept> m_targets;
    std::uint64_t m_uses = 0;
    int m_mostSamples = 1;
    bool m_isRichBroken = false; // its programs are
    bool m_isNoticed = false;
    std::string m_notice;
};

} // namespace trundle
