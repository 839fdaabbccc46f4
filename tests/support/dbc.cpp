#include "tests/support/dbc.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <stdexcept>

namespace terratact {
namespace {

const std::string kNumber = R"((-?[0-9]+(?:\.[0-9]+)?))";
const std::string kName = "([A-Za-z_][A-Za-z0-9_]*)";
const std::string kText = "\"([^\"]*)\"";

class Reader {
public:
    void take(const std::string& line)
    {
        const bool known = message(line) || signal(line) || comment(line) || attribute(line)
                        || words(line) || preamble(line);
        if (!known) throw std::runtime_error("not understood: " + line);
    }
    std::vector<DbcMessage> messages;

private:
    DbcMessage& find(const std::string& id)
    {
        for (DbcMessage& m : messages)
            if (std::to_string(m.id) == id) return m;
        throw std::runtime_error("no message " + id);
    }
    DbcSignal& find(const std::string& id, const std::string& name)
    {
        return const_cast<DbcSignal&>(find(id).signal(name));
    }
    bool matches(const std::string& line, const std::string& pattern)
    {
        return std::regex_match(line, m_, std::regex(pattern));
    }
    bool message(const std::string& line)
    {
        if (!matches(line, "BO_ ([0-9]+) " + kName + ": ([0-9]+) " + kName)) return false;
        DbcMessage& m = messages.emplace_back();
        m.id = static_cast<unsigned>(std::stoul(m_[1]));
        m.name = m_[2];
        m.length = std::stoi(m_[3]);
        m.sender = m_[4];
        return true;
    }
    bool signal(const std::string& line)
    {
        if (!matches(line, " SG_ " + kName + " : ([0-9]+)\\|([0-9]+)@1([+-]) \\(" + kNumber + ","
                               + kNumber + "\\) \\[" + kNumber + "\\|" + kNumber + "\\] " + kText
                               + " " + kName))
            return false;
        DbcSignal& s = messages.back().signals.emplace_back();
        s.name = m_[1];
        s.start = std::stoi(m_[2]);
        s.length = std::stoi(m_[3]);
        s.isSigned = m_[4] == "-";
        s.scale = std::stod(m_[5]);
        s.offset = std::stod(m_[6]);
        s.least = std::stod(m_[7]);
        s.most = std::stod(m_[8]);
        s.unit = m_[9];
        s.receiver = m_[10];
        return true;
    }
    bool comment(const std::string& line)
    {
        if (matches(line, "CM_ BO_ ([0-9]+) " + kText + ";")) {
            find(m_[1]).comment = m_[2];
            return true;
        }
        if (matches(line, "CM_ SG_ ([0-9]+) " + kName + " " + kText + ";")) {
            find(m_[1], m_[2]).comment = m_[3];
            return true;
        }
        return matches(line, "CM_ (BU_ " + kName + " )?" + kText + ";");
    }
    bool attribute(const std::string& line)
    {
        if (!matches(line, "BA_ " + kText + " BO_ ([0-9]+) ([0-9]+);")) return false;
        find(m_[2]).attributes[m_[1]] = std::stoi(m_[3]);
        return true;
    }
    bool words(const std::string& line)
    {
        if (!matches(line, "VAL_ ([0-9]+) " + kName + "((?: [0-9]+ \"[^\"]*\")+) ;")) return false;
        DbcSignal& s = find(m_[1], m_[2]);
        const std::string pairs = m_[3];
        const std::regex pair("([0-9]+) " + kText);
        for (std::sregex_iterator i(pairs.begin(), pairs.end(), pair), end; i != end; ++i)
            s.words[std::stoi((*i)[1])] = (*i)[2];
        return true;
    }
    bool preamble(const std::string& line)
    {
        return line.empty() || line.starts_with('\t') || line == "NS_ :" || line == "BS_:"
            || line == "BU_: Console Robot" || line.starts_with("VERSION ")
            || line.starts_with("BA_DEF_ ") || line.starts_with("BA_DEF_DEF_ ");
    }

    std::smatch m_;
};

}  // namespace

const DbcSignal& DbcMessage::signal(const std::string& signalName) const
{
    const auto found = std::find_if(signals.begin(), signals.end(),
                                    [&](const DbcSignal& s) { return s.name == signalName; });
    if (found == signals.end()) throw std::out_of_range(name + " has no signal " + signalName);
    return *found;
}

std::vector<DbcMessage> readDbc(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot open " + path);
    Reader reader;
    for (std::string line; std::getline(file, line);) reader.take(line);
    return reader.messages;
}

}  // namespace terratact
