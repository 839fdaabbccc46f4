#pragma once

#include "app/shell/page.h"

namespace terratact {

class AlarmTable;
class ConsoleAlarms;

/// The page of the alarm table.
class AlarmsPage final : public Page {
    Q_OBJECT
public:
    explicit AlarmsPage(ConsoleAlarms& alarms, QWidget* parent = nullptr);
    void refresh(double now) override;
    AlarmTable* table() const { return table_; }

private:
    ConsoleAlarms& alarms_;
    AlarmTable* table_ = nullptr;
};

}  // namespace terratact
