#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/base/message.h"
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

    /// seconds: computation time; memory: text about what the estimate remembers of the way. A warning of one side
    /// names that side.
    void setEstimate(const TwoTrackEstimate& estimate, double seconds, const QString& memory = {});
    /// Shows an estimate of one plane.
    void setEstimate(const TerrainEstimate& plane, double seconds, const QString& memory = {});
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
    void showEstimate(const TerrainEstimate& widest, ProbeSide side, double seconds,
                      const QString& memory);
    void showWarnings(const std::vector<Message>& warnings);
    void resizeToFont();
    void arrange();  ///< shortens or hides the details if the sentence needs their room

    bool arranges_ = false;
    QStringList detailTexts_;  ///< texts of the details, the longest first
    QLabel* headline_ = nullptr;
    QLabel* details_ = nullptr;
    QLabel* warnings_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QPushButton* cancel_ = nullptr;
};

}  // namespace terratact
