#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>

namespace terratact {

class MainWindow;

/// Plays the operator of the simulated robot: arms it, drives up to the step, asks for an exploration, and
/// saves a picture of the window once the first estimate stands on it.  Where no step comes, it explores where it stands,
/// and stderr says so.  Ends the program's event loop with 0; or with 1 and a sentence on stderr, and a picture of
/// what stood in the way where the console itself works.
class ScreenshotDemo final : public QObject {
    Q_OBJECT
public:
    ScreenshotDemo(MainWindow& window, QString file);

private:
    enum class Stage { Loading, Driving, Exploring, Settling };
    void tick();
    void arm();
    bool seesStep() const;
    QString save();
    void finish();
    void giveUp(const QString& why);
    void fail(const QString& why);

    MainWindow& window_;
    QString file_;
    QTimer timer_;
    Stage stage_ = Stage::Loading;
    double began_ = 0.0;           // [s]
    double settled_ = 0.0;         // [s]
    std::optional<double> drove_;  // [s] since when
};

}  // namespace terratact
