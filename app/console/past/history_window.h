#pragma once

#include <QWidget>
#include <cstdint>

class QLabel;
class QListWidget;
class QPushButton;

namespace terratact {

class EstimateHistory;

/// The estimates of this run as a list, newest first, each with a thumbnail. It emits what the
/// operator wants to see and changes nothing itself: to open it chooses no estimate. Up, Down and
/// the mouse choose an estimate to show. L lays it over the present one; Backspace returns to the
/// present. Ctrl+Z brings a hidden estimate back, and Esc closes the window.
class HistoryWindow final : public QWidget {
    Q_OBJECT
public:
    /// history: must outlive the object.
    explicit HistoryWindow(const EstimateHistory& history, QWidget* parent);

    /// Numbers of the estimates in the picture; 0: none. canRestore: a hidden estimate may be brought back.
    void setShown(std::int64_t shown, std::int64_t laid, bool canRestore);

    QListWidget* list() const { return list_; }
    QPushButton* layButton() const { return lay_; }
    QPushButton* presentButton() const { return present_; }
    QPushButton* restoreButton() const { return restore_; }
    QLabel* stateLabel() const { return state_; }

signals:
    void showWanted(qlonglong number);
    void layWanted(qlonglong number);  ///< 0: nothing is laid over
    void presentWanted();
    void restoreWanted();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fill();
    void showState();
    bool act(const QKeyEvent& event);
    bool chooseFirst(const QKeyEvent& event);
    std::int64_t chosen() const;  ///< the selected one, not the one with the focus; 0: none

    const EstimateHistory& history_;
    std::int64_t shown_ = 0, laid_ = 0;
    bool canRestore_ = false;
    QLabel* state_ = nullptr;
    QListWidget* list_ = nullptr;
    QPushButton* lay_ = nullptr;
    QPushButton* present_ = nullptr;
    QPushButton* restore_ = nullptr;
};

}  // namespace terratact
