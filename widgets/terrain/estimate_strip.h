#pragma once

#include <QWidget>
#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace terratact {

struct TerrainEstimate;

/// The line above the terrain: what the estimate says in one sentence, how it was made, and the
/// progress of one under way, with cancel.  What makes it doubtful stands in a label of its own, to be
/// placed below.
class EstimateStrip final : public QWidget {
    Q_OBJECT
public:
    explicit EstimateStrip(QWidget* parent = nullptr);

    void setEstimate(const TerrainEstimate& estimate, double seconds);  ///< seconds it took
    void setLive(const QString& note);  ///< a preview is shown, and what that means
    void setNothing(const QString& why);
    void setProgress(std::optional<double> share);  ///< empty: nothing under way

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
    void resizeToFont();
    void arrange();  ///< leaves the details out where the sentence needs their room

    bool arranges_ = false;
    QLabel* headline_ = nullptr;
    QLabel* details_ = nullptr;
    QLabel* warnings_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QPushButton* cancel_ = nullptr;
};

}  // namespace terratact
