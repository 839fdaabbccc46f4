#pragma once

#include <QList>
#include <QString>
#include <QWidget>

class QLineEdit;
class QListWidget;

namespace terratact {

/// A signal in SignalList.
struct ListedSignal {
    QString key;   ///< names it in intents
    QString text;  ///< "telemetry · pitch [rad]"
    bool isPlotted = false;
    bool operator==(const ListedSignal&) const = default;
};

/// All signals, with a filter. A signal is dragged out with the mouse, or chosen with the keys. A drag never takes keys
/// away, as a drag of the desktop does: STOP works meanwhile.
class SignalList final : public QWidget {
    Q_OBJECT
public:
    explicit SignalList(QWidget* parent = nullptr);

    /// Keeps filter and choice.
    void setSignals(const QList<ListedSignal>& all);
    QString chosenKey() const;  ///< empty: none
    void choose(const QString& key);

    QLineEdit* filter() const { return filter_; }
    QListWidget* list() const { return list_; }

signals:
    void dragged(const QString& key, const QPoint& global);
    void dropped(const QString& key, const QPoint& global);
    void dragEnded();
    void wanted(const QString& key);  ///< by double click or Enter

private:
    void applyFilter();

    QList<ListedSignal> all_;
    QLineEdit* filter_ = nullptr;
    QListWidget* list_ = nullptr;
};

}  // namespace terratact
