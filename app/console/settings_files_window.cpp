#include "app/console/settings_files_window.h"

#include <QFile>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/shell/file_dialog.h"
#include "app/shell/new_file.h"
#include "app/shell/second_press.h"
#include "widgets/base/card.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr int kWide = 720, kHigh = 560;  // [px] at 100 %
constexpr int kCheckPeriod = 250;        // [ms] whether the robot is armed or moves

QPushButton* pressable(const QString& text, QWidget* parent)
{
    auto* button = new QPushButton(text, parent);
    button->setMinimumHeight(kTarget);
    button->setAutoDefault(false);  // Return in the name field presses nothing
    return button;
}

QTableWidgetItem* cellOf(const QString& text)
{
    auto* item = new QTableWidgetItem(text);
    setTip(*item, text);
    return item;
}

}  // namespace

SettingsFilesWindow::SettingsFilesWindow(PreferenceStore& store, Options options, QWidget* parent)
    : QDialog(parent), store_(store), options_(std::move(options))
{
    setWindowTitle(tr("Profiles, export and import of settings"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 14);
    column->setSpacing(10);
    column->addWidget(buildProfiles(), 1);
    column->addWidget(buildFiles());
    column->addWidget(buildChanges(), 2);
    result_ = new PlainLabel(this);
    result_->setWordWrap(true);
    result_->setAccessibleName(tr("Result"));
    result_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    column->addWidget(result_);
    showProfiles();
    dropProposal();
    // The report of a written or applied file is outdated once a setting changes.
    connect(&store_, &PreferenceStore::changed, this, [this] { report({}, false); });
    connect(&store_, &PreferenceStore::changed, this, &SettingsFilesWindow::showChanges);
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, [this] {
        if (isVisible()) showButtons();
    });
    timer->start(kCheckPeriod);
    resize(scaled(kWide), scaled(kHigh));
}

QWidget* SettingsFilesWindow::buildProfiles()
{
    auto* card = new Card(tr("Profiles"), this);
    list_ = new QListWidget(card);
    list_->setAccessibleName(tr("Profiles"));
    list_->setMinimumHeight(scaled(80));
    switch_ = pressable(tr("Switch to it …"), card);
    delete_ = pressable(tr("Delete it"), card);
    auto* of = new QVBoxLayout;
    of->addWidget(switch_);
    of->addWidget(delete_);
    of->addStretch(1);
    auto* row = new QHBoxLayout;
    row->addWidget(list_, 1);
    row->addLayout(of);
    name_ = new QLineEdit(card);
    name_->setMinimumHeight(kTarget);
    name_->setAccessibleName(tr("Name of a profile"));
    name_->setPlaceholderText(tr("name, for example: robot A/night"));
    setTip(*name_, tr("The present settings are saved under this name"));
    save_ = pressable(tr("Save the present settings"), card);
    replace_ = pressable(tr("Replace the profile"), card);
    auto* saving = new QHBoxLayout;
    saving->addWidget(name_, 1);
    saving->addWidget(save_);
    saving->addWidget(replace_);
    card->body()->addLayout(row, 1);
    card->body()->addLayout(saving);

    connect(list_, &QListWidget::currentRowChanged, this, [this] {
        if (const QString chosen = chosenProfile(); !chosen.isEmpty()) name_->setText(chosen);
        showButtons();
    });
    const auto propose = [this] {
        const QString chosen = chosenProfile();
        if (!chosen.isEmpty()) this->propose(profilePath(options_.folder, chosen), chosen);
    };
    connect(list_, &QListWidget::itemActivated, this, propose);
    connect(switch_, &QPushButton::clicked, this, propose);
    connect(name_, &QLineEdit::textChanged, this, &SettingsFilesWindow::showButtons);
    connect(name_, &QLineEdit::returnPressed, this, [this] {
        if (save_->isVisible() && save_->isEnabled()) saveProfile(false);
    });
    connect(save_, &QPushButton::clicked, this, [this] { saveProfile(false); });
    auto* replaces = new SecondPress(*replace_, tr("Press again to replace it"));
    connect(replaces, &SecondPress::confirmed, this, [this] { saveProfile(true); });
    auto* deletes = new SecondPress(*delete_, tr("Press again to delete it"));
    connect(deletes, &SecondPress::confirmed, this, &SettingsFilesWindow::removeProfile);
    // A second press counts for the profile of the first one alone.
    connect(list_, &QListWidget::currentRowChanged, deletes, &SecondPress::cancel);
    connect(name_, &QLineEdit::textChanged, replaces, &SecondPress::cancel);
    return card;
}

QWidget* SettingsFilesWindow::buildFiles()
{
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    export_ = pressable(tr("Export to a file …"), row);
    setTip(*export_, tr("Writes all settings but the files of this computer; in SI units"));
    import_ = pressable(tr("Import a file …"), row);
    setTip(*import_, tr("Shows what the file would change before it is applied"));
    line->addWidget(export_);
    line->addWidget(import_);
    line->addStretch(1);
    const QString filter = tr("Settings (*.settings)");
    connect(export_, &QPushButton::clicked, this, [this, filter] {
        askForFile(*this,
                   {.title = tr("Export settings"),
                    .start = QStringLiteral("terratact.settings"),
                    .filter = filter,
                    .kind = FileWish::Kind::ToWrite},
                   [this](const QString& path) { exportTo(path); });
    });
    connect(import_, &QPushButton::clicked, this, [this, filter] {
        askForFile(*this,
                   {.title = tr("Import settings"), .start = documentsFolder(), .filter = filter},
                   [this](const QString& path) { propose(path, format::fileName(path)); });
    });
    return row;
}

QWidget* SettingsFilesWindow::buildChanges()
{
    auto* card = new Card(tr("What will change"), this);
    changesPart_ = card;
    changesTitle_ = new PlainLabel(card);
    changesTitle_->setWordWrap(true);
    safety_ = new PlainLabel(card);
    safety_->setWordWrap(true);
    safety_->setAccessibleName(tr("Safety-relevant changes"));
    setTone(*safety_, Tone::Bad);
    changes_ = new HeadedTable(0, 3, card);
    changes_->setAccessibleName(tr("What will change"));
    changes_->setHorizontalHeaderLabels({tr("Setting"), tr("now"), tr("then")});
    changes_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    changes_->verticalHeader()->hide();
    changes_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    changes_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    changes_->setTabKeyNavigation(false);
    changes_->setMinimumHeight(scaled(100));
    apply_ = pressable(tr("Apply"), card);
    apply_->setProperty("role", "primary");
    drop_ = pressable(tr("Leave all as it is"), card);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(apply_);
    row->addWidget(drop_);
    card->body()->addWidget(changesTitle_);
    card->body()->addWidget(safety_);
    card->body()->addWidget(changes_, 1);
    card->body()->addLayout(row);
    connect(apply_, &QPushButton::clicked, this, &SettingsFilesWindow::apply);
    connect(drop_, &QPushButton::clicked, this, [this] {
        dropProposal();
        report(tr("Nothing was changed"), false);
    });
    return card;
}

QString SettingsFilesWindow::chosenProfile() const
{
    const QListWidgetItem* const item = list_->currentItem();
    return item ? item->text() : QString();
}

void SettingsFilesWindow::showProfiles(const QString& chosen)
{
    list_->clear();
    list_->addItems(profilesIn(options_.folder));
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->text() == chosen) list_->setCurrentRow(i);
    showButtons();
}

void SettingsFilesWindow::showButtons()
{
    const auto offer = [](QPushButton* button, const std::optional<QString>& whyNot,
                          const QString& tip) {
        button->setEnabled(!whyNot);
        setTip(*button, whyNot.value_or(tip));
    };
    const auto blocked = options_.whyNot ? options_.whyNot() : std::nullopt;
    std::optional<QString> whyNot, whyNoName;
    if (blocked) whyNot = translated(*blocked);
    const QString name = name_->text().trimmed();
    if (options_.folder.isEmpty())
        whyNoName = tr("There is no place for profiles: settings are not saved");
    else if (const auto why = whyNoProfileName(name))
        whyNoName = translated(*why);
    const bool isThere =
        !whyNoName && !list_->findItems(name, Qt::MatchExactly | Qt::MatchCaseSensitive).isEmpty();
    std::optional<QString> whyNoChoice;
    if (chosenProfile().isEmpty()) whyNoChoice = tr("Choose a profile first");
    offer(switch_, whyNoChoice ? whyNoChoice : whyNot, tr("Shows what it would change first"));
    offer(delete_, whyNoChoice, tr("Asks for a second press"));
    offer(save_, whyNoName, tr("Saves all settings as a new profile"));
    offer(replace_, whyNoName, tr("A profile of this name exists; asks for a second press"));
    save_->setVisible(!isThere);
    replace_->setVisible(isThere);
    offer(import_, whyNot, tr("Shows what the file would change before it is applied"));
    offer(apply_, whyNot, tr("Applies the changes listed here"));
}

void SettingsFilesWindow::report(const QString& text, bool isBad)
{
    result_->setText(text);
    setTone(*result_, isBad ? Tone::Bad : Tone::Plain);
}

QString SettingsFilesWindow::result() const
{
    return result_->text();
}

void SettingsFilesWindow::saveProfile(bool replaces)
{
    const QString name = name_->text().trimmed();
    if (whyNoProfileName(name) || options_.folder.isEmpty()) return showButtons();
    const Status saved = writeSettings(profilePath(options_.folder, name).toStdString(),
                                       store_.current(), SettingsScope::ThisComputer, replaces);
    if (!saved) return report(translated(saved.error().message), true);
    showProfiles(name);
    report(tr("Saved as profile “%1”").arg(name), false);
}

void SettingsFilesWindow::removeProfile()
{
    const QString name = chosenProfile();
    const bool gone = !name.isEmpty() && QFile::remove(profilePath(options_.folder, name));
    report(gone ? tr("Deleted: profile “%1”").arg(name)
                : tr("The profile “%1” could not be deleted").arg(name),
           !gone);
    showProfiles();
}

void SettingsFilesWindow::exportTo(const QString& path)
{
    const QString ending = QStringLiteral(".settings");
    const QString file = path.endsWith(ending) ? path : path + ending;
    const Status saved =
        writeSettings(file.toStdString(), store_.current(), SettingsScope::Anywhere);
    report(saved ? tr("Written: %1").arg(file) : translated(saved.error().message), !saved);
}

void SettingsFilesWindow::propose(const QString& path, const QString& name)
{
    dropProposal();
    auto file = readSettingsFile(path.toStdString());
    if (!file) return report(translated(file.error().message), true);
    proposal_ = std::move(*file);
    proposedName_ = name;
    report({}, false);
    showChanges();
    changes_->setFocus();
}

void SettingsFilesWindow::dropProposal()
{
    proposal_.reset();
    changesPart_->hide();
    showButtons();
}

void SettingsFilesWindow::showChanges()
{
    if (!proposal_) return;
    proposed_ = changesBetween(store_.current(), withSettings(store_.current(), *proposal_));
    if (proposed_.empty()) {
        dropProposal();
        return report(tr("“%1” changes nothing: these settings are active").arg(proposedName_),
                      false);
    }
    const int count = static_cast<int>(proposed_.size());
    QStringList safety;
    changes_->setRowCount(count);
    for (int row = 0; row < count; ++row) {
        const PreferenceChange& change = proposed_.at(static_cast<std::size_t>(row));
        const QString label = change.isSafety ? tr("safety: %1").arg(change.label) : change.label;
        changes_->setItem(row, 0, cellOf(label));
        changes_->setItem(row, 1, cellOf(change.before));
        changes_->setItem(row, 2, cellOf(change.now));
        if (change.isSafety)
            safety << tr("%1: %2 → %3").arg(change.label, change.before, change.now);
    }
    changesTitle_->setText(tr("“%1” changes:").arg(proposedName_));
    safety_->setText(tr("Safety-relevant: %1").arg(safety.join(QStringLiteral("; "))));
    safety_->setVisible(!safety.isEmpty());
    apply_->setText(safety.isEmpty() ? tr("Apply") : tr("Apply, safety-relevant changes too"));
    changesPart_->show();
    showButtons();
}

void SettingsFilesWindow::apply()
{
    if (!proposal_) return;
    if (const auto why = options_.whyNot ? options_.whyNot() : std::nullopt) {
        showButtons();
        return report(tr("Not applied: %1").arg(translated(*why)), true);
    }
    const SettingsFile file = *proposal_;
    const QString name = proposedName_;
    dropProposal();
    emit applied({TR_NOOP("terratact::SettingsFilesWindow", "settings of “%1” came into force"),
                  verbatim(name)});
    store_.change([&file](Preferences& p) { p = withSettings(std::move(p), file); });
    report(tr("In force: “%1”").arg(name), false);
}

}  // namespace terratact
