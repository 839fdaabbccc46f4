#pragma once

#include "app/review/review_payload.h"
#include "app/shell/page.h"

class QLabel;

namespace terratact {

class DbcFiles;
class PreferenceStore;
class SignalTable;

/// What other devices than the robot had sent up to a time of a session: gas sensors, batteries.
class ReviewSignalsPage final : public Page {
    Q_OBJECT
public:
    /// Both must outlive it.
    ReviewSignalsPage(SessionReader& session, PreferenceStore& preferences,
                      QWidget* parent = nullptr);

    /// Shows that time from now on; it is read once the page is seen.
    void setTime(SessionTime time);
    void refresh(double now) override;

    SignalTable* table() const { return table_; }
    QLabel* headline() const { return headline_; }
    DbcFiles* dbc() const { return dbc_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    ReviewPayload payload_;
    SessionTime time_ = 0;
    DbcFiles* dbc_ = nullptr;
    QLabel* headline_ = nullptr;
    SignalTable* table_ = nullptr;
};

}  // namespace terratact
