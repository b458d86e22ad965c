#pragma once
// Records a movie of an experiment: simulates it again in a worker thread, as fast as possible, and renders it at exact
// simulated times.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QObject>

#include "app/application.h"
#include "render/service.h"
#include "run/command.h"

namespace trundle {

/// The camera view for given poses of the bodies.
using MovingView = std::function<CameraView(const BodyPoses& poses)>;

struct MovieJob {
    std::shared_ptr<const LoadedProject> loaded; ///< the experiment to run
    std::vector<Command> commands;               ///< commands given in the run that is repeated
    double begin = 0, end = 0;                   ///< simulated s
    std::string camera;                          ///< "robot0/eye"; if empty, `view` and `look` are used:
    MovingView view;
    PictureRequest look; ///< size, overlays and hidden objects; scene, view and poses are ignored
    double framesPerSecond = 30;
    std::string path; ///< .mp4 or .webm; written to this path only when complete

    [[nodiscard]] std::uint64_t frameCount() const;
};

/// Records at most one movie at a time.
class MovieRecorder final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive this object.
    MovieRecorder(Application& application, RenderService& render, QObject* parent = nullptr);
    /// Waits at most two seconds; a controller that does not return is abandoned.
    ~MovieRecorder() override;

    void start(MovieJob job);
    /// Takes effect after the current image: finished() follows, and the incomplete movie is deleted.
    void cancel();
    [[nodiscard]] bool isRecording() const { return m_state != nullptr; }

Q_SIGNALS:
    /// 0 images while it simulates up to the beginning.
    void progressed(quint64 pictures, double time);
    void finished(const QString& failure, bool cancelled); ///< empty and false: the movie was written

private:
    struct MovieState;
    static void record(MovieState& state, const MovieJob& job);
    static Result<bool> film(MovieState& state, const MovieJob& job);

    Application& m_application;
    RenderService& m_render;
    std::shared_ptr<MovieState> m_state;
};

} // namespace trundle
