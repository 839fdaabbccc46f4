#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>

namespace terratact {

class MainWindow;

/// Plays the operator of the simulated robot: it arms, drives to the step and explores. Then it saves a picture of the
/// window with the first estimate. Without a step it explores at its place and prints a notice on stderr. It ends the
/// event loop with 0. On failure it ends with 1, prints a sentence on stderr and saves a picture if it can.
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
    std::optional<double> drove_;  // [s] start of the drive
};

}  // namespace terratact
