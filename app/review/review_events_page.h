#pragma once

#include <QTableView>
#include <vector>

#include "app/shell/page.h"
#include "core/log/session_reader.h"

class QComboBox;
class QLabel;

namespace terratact {

class ReviewEvents;
struct ReviewMoment;

/// All events of a session with their times. Choosing a row shows its time.
class ReviewEventsPage final : public Page {
    Q_OBJECT
public:
    explicit ReviewEventsPage(const SessionReader& session, QWidget* parent = nullptr);

    void reload();  ///< call after the session has grown
    void setMoment(const ReviewMoment& moment);
    void refresh(double /*now*/) override {}

    QTableView* table() const { return table_; }
    QComboBox* kinds() const { return kinds_; }

signals:
    void seekWanted(double seconds);

protected:
    void changeEvent(QEvent* event) override;

private:
    void resizeToFont();

    ReviewEvents* events_ = nullptr;
    QLabel* alarms_ = nullptr;
    QComboBox* kinds_ = nullptr;
    QTableView* table_ = nullptr;
};

}  // namespace terratact
