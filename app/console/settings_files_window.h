#pragma once

#include <QDialog>
#include <functional>
#include <optional>
#include <vector>

#include "app/shell/preferences/preference_store.h"
#include "app/shell/preferences/preference_text.h"
#include "app/shell/preferences/settings_file.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace terratact {

/// Window for named profiles, export and import of settings. Nothing changes before the operator has seen every change
/// and pressed Apply; safety-relevant changes are named. Nothing is overwritten without a second press.
class SettingsFilesWindow final : public QDialog {
    Q_OBJECT
public:
    struct Options {
        QString folder{};  ///< of the profiles; empty: they cannot be saved
        /// Returns why settings must not change now; empty: they may.
        std::function<std::optional<Message>()> whyNot;
    };
    SettingsFilesWindow(PreferenceStore& store, Options options, QWidget* parent = nullptr);

    /// Shows what a file of settings would change. name: what the operator calls it.
    void propose(const QString& path, const QString& name);
    void exportTo(const QString& path);  ///< writes an export; refuses to replace a file

    QListWidget* list() const { return list_; }
    QLineEdit* nameField() const { return name_; }
    QPushButton* switchButton() const { return switch_; }
    QPushButton* deleteButton() const { return delete_; }
    QPushButton* saveButton() const { return save_; }
    QPushButton* replaceButton() const { return replace_; }
    QPushButton* applyButton() const { return apply_; }
    QPushButton* dropButton() const { return drop_; }
    QTableWidget* changes() const { return changes_; }
    QString result() const;

signals:
    /// Settings of a file came into force.
    void applied(const terratact::Message& text);

private:
    QWidget* buildProfiles();
    QWidget* buildFiles();
    QWidget* buildChanges();
    void showProfiles(const QString& chosen = {});
    void showChanges();
    void showButtons();
    void report(const QString& text, bool isBad);
    void saveProfile(bool replaces);
    void removeProfile();
    void apply();
    void dropProposal();
    QString chosenProfile() const;

    PreferenceStore& store_;
    Options options_;
    std::optional<SettingsFile> proposal_;
    QString proposedName_;
    std::vector<PreferenceChange> proposed_;
    QListWidget* list_ = nullptr;
    QLineEdit* name_ = nullptr;
    QPushButton* switch_ = nullptr;
    QPushButton* delete_ = nullptr;
    QPushButton* save_ = nullptr;
    QPushButton* replace_ = nullptr;
    QPushButton* export_ = nullptr;
    QPushButton* import_ = nullptr;
    QWidget* changesPart_ = nullptr;
    QLabel* changesTitle_ = nullptr;
    QLabel* safety_ = nullptr;
    QTableWidget* changes_ = nullptr;
    QPushButton* apply_ = nullptr;
    QPushButton* drop_ = nullptr;
    QLabel* result_ = nullptr;
};

}  // namespace terratact
