#pragma once

#include <QWidget>
#include <optional>

#include "core/robot/probe_side.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace terratact {

struct TerrainEstimate;
struct TwoTrackEstimate;

/// The line above the terrain. It has one sentence about the estimate, how it was made, and the progress of a running
/// one with Cancel. Warnings have a label of their own, which the page places below.
class EstimateStrip final : public QWidget {
    Q_OBJECT
public:
    explicit EstimateStrip(QWidget* parent = nullptr);

    void setEstimate(const TwoTrackEstimate& estimate,
                     double seconds);  ///< seconds: computation time
    /// Shows an estimate of one plane.
    void setEstimate(const TerrainEstimate& plane, double seconds);
    void setLive(const QString& note);  ///< marks the estimate as a live preview; note: its meaning
    void setNothing(const QString& why);
    void setProgress(std::optional<double> share);  ///< empty: no estimate is running

    QLabel* warnings() const { return warnings_; }
    QString headline() const;
    QString details() const;
    QString warningText() const;
    QPushButton* cancelButton() const { return cancel_; }

signals:
    void cancelled();

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void showEstimate(const TerrainEstimate& widest, ProbeSide side, double seconds);
    void showWarnings(const QStringList& warnings);
    void resizeToFont();
    void arrange();  ///< hides the details if the sentence needs their room

    bool arranges_ = false;
    QLabel* headline_ = nullptr;
    QLabel* details_ = nullptr;
    QLabel* warnings_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QPushButton* cancel_ = nullptr;
};

}  // namespace terratact
