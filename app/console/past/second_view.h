#pragma once

#include <QWidget>

#include "app/pages/terrain_page.h"

namespace terratact {

class PlainLabel;

/// A window for a second screen. It shows terrain, verdict, memory line and drive strip like the console, with the same
/// marks of stale data. Nothing in it commands the robot or changes the verdict. It follows theme and font. F11 fills
/// its screen, but never covers the console's header. Esc and Ctrl+D close it.
class SecondView final : public QWidget {
    Q_OBJECT
public:
    /// source: the source's name, for the title. console: the window that owns it.
    SecondView(const RobotModel& robot, const QString& source, QWidget& console);

    /// Shows what the console shows. stepLimit, threshold: obstacle height [m] and contact threshold [N] of the
    /// console's page. banner: its link banner; empty: none.
    void show(const TerrainViewState& viewState, double stepLimit, double threshold,
              const QString& banner);
    /// Opens the window without taking the keys from the console. It is on another screen if there
    /// is one, else below the console's header.
    void open();
    TerrainPage* page() const { return page_; }
    PlainLabel* banner() const { return banner_; }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void arrange();
    void fillScreen();
    void forbid();

    double threshold_ = -1.0;
    // Qt's parents own the widgets.
    TerrainPage* page_ = nullptr;
    PlainLabel* banner_ = nullptr;
    QWidget* away_ = nullptr;  ///< never shown: the parts of the page that command
};

}  // namespace terratact
