#include "core/bags/json_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/base/text.h"

namespace terratact {
namespace {

class JsonParser {
public:
    explicit JsonParser(std::string_view text) : text_(text) {}

    Result<FieldValue> parse()
    {
        FieldValue value;
        skipBlanks();
        if (!read(value, 0)) return Error{why_};
        skipBlanks();
        if (at_ != text_.size()) {
            refuse("has text behind its value");
            return Error{why_};
        }
        return value;
    }

private:
    bool refuse(std::string_view cause)
    {
        if (why_.empty()) why_ = fmt::format("is no JSON at byte {}: {}", at_, cause);
        return false;
    }

    void skipBlanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

    char front() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    bool consume(char wanted)
    {
        if (front() != wanted) return false;
        ++at_;
        return true;
    }

    bool consumeWord(std::string_view word)
    {
        if (text_.substr(at_, word.size()) != word) return false;
        at_ += word.size();
        return true;
    }

    bool read(FieldValue& into, int depth)
    {
        if (depth >= FieldValue::kDeepest) return refuse("it nests too deep");
        if (++values_ > FieldValue::kMaxValues) return refuse("it holds too many values");
        switch (front()) {
        case '{': return readObject(into, depth);
        case '[': return readArray(into, depth);
        case '"': into.kind = FieldValue::Kind::Text; return readText(into.text);
        default: return readWord(into);
        }
    }

    bool readWord(FieldValue& into)
    {
        if (consumeWord("null")) return true;
        into.kind = FieldValue::Kind::Number;
        if (consumeWord("true")) return into.number = 1.0, true;
        if (consumeWord("false")) return true;
        const std::size_t end =
            std::min(text_.find_first_not_of("+-.0123456789eE", at_), text_.size());
        const auto number = numberFrom(text_.substr(at_, end - at_));
        if (!number) return refuse("expected a value");
        into.number = *number;
        at_ = end;
        return true;
    }

    bool readObject(FieldValue& into, int depth)
    {
        into.kind = FieldValue::Kind::Members;
        ++at_;
        skipBlanks();
        if (consume('}')) return true;
        do {
            skipBlanks();
            FieldValue& part = into.parts.emplace_back();
            if (!readText(part.name)) return false;
            skipBlanks();
            if (!consume(':')) return refuse("expected ':'");
            skipBlanks();
            if (!read(part, depth + 1)) return false;
            skipBlanks();
        } while (consume(','));
        return consume('}') || refuse("expected ',' or '}'");
    }

    bool readArray(FieldValue& into, int depth)
    {
        into.kind = FieldValue::Kind::Items;
        ++at_;
        skipBlanks();
        if (!consume(']')) {
            do {
                skipBlanks();
                FieldValue part;
                if (!read(part, depth + 1)) return false;
                if (into.parts.size() < FieldValue::kMaxElements)
                    into.parts.push_back(std::move(part));
                skipBlanks();
            } while (consume(','));
            if (!consume(']')) return refuse("expected ',' or ']'");
        }
        simplify(into);
        return true;
    }

    /// Makes numbers or texts of an array whose elements are all of that kind.
    static void simplify(FieldValue& array)
    {
        using Kind = FieldValue::Kind;
        const auto all = [&array](auto isOne) { return std::ranges::all_of(array.parts, isOne); };
        if (all([](const FieldValue& v) { return v.kind == Kind::Text; }) && !array.parts.empty()) {
            array.kind = Kind::Texts;
            array.texts.reserve(array.parts.size());
            for (FieldValue& part : array.parts) array.texts.push_back(std::move(part.text));
            array.parts.clear();
        } else if (all([](const FieldValue& v) {
                       return v.kind == Kind::Number || v.kind == Kind::Nothing;
                   })) {
            array.kind = Kind::Numbers;
            array.numbers.reserve(array.parts.size());
            for (const FieldValue& part : array.parts)
                array.numbers.push_back(part.kind == Kind::Number
                                            ? part.number
                                            : std::numeric_limits<double>::quiet_NaN());
            array.parts.clear();
        }
    }

    bool readText(std::string& into)
    {
        if (!consume('"')) return refuse("expected a text in quotes");
        for (;;) {
            const std::size_t end = text_.find_first_of("\"\\", at_);
            if (end == std::string_view::npos) return refuse("a text does not end");
            into += text_.substr(at_, end - at_);
            at_ = end + 1;
            if (text_[end] == '"') return true;
            if (!readEscape(into)) return refuse("unknown escape in a text");
        }
    }

    bool readEscape(std::string& into)
    {
        const char c = front();
        ++at_;
        switch (c) {
        case '"':
        case '\\':
        case '/': into += c; return true;
        case 'b': into += '\b'; return true;
        case 'f': into += '\f'; return true;
        case 'n': into += '\n'; return true;
        case 'r': into += '\r'; return true;
        case 't': into += '\t'; return true;
        case 'u': return readCodePoint(into);
        default: return false;
        }
    }

    std::optional<unsigned> hexadecimal()
    {
        if (at_ + 4 > text_.size()) return std::nullopt;
        const auto code = integerFrom<unsigned>(text_.substr(at_, 4), 16);
        at_ += 4;
        return code;
    }

    bool readCodePoint(std::string& into)
    {
        auto code = hexadecimal();
        if (!code) return false;
        if (*code >= 0xD800 && *code < 0xDC00) {  // the first half of a pair
            if (!consumeWord("\\u")) return false;
            const auto low = hexadecimal();
            if (!low || *low < 0xDC00 || *low >= 0xE000) return false;
            code = 0x10000 + ((*code - 0xD800) << 10U) + (*low - 0xDC00);
        }
        addUtf8(into, *code);
        return true;
    }

    static void addUtf8(std::string& into, unsigned code)
    {
        const auto byte = [&into](unsigned bits) { into += static_cast<char>(bits); };
        if (code < 0x80) return byte(code);
        if (code < 0x800) {
            byte(0xC0U | code >> 6U);
        } else if (code < 0x10000) {
            byte(0xE0U | code >> 12U);
            byte(0x80U | (code >> 6U & 0x3FU));
        } else {
            byte(0xF0U | code >> 18U);
            byte(0x80U | (code >> 12U & 0x3FU));
            byte(0x80U | (code >> 6U & 0x3FU));
        }
        byte(0x80U | (code & 0x3FU));
    }

    std::string_view text_;
    std::size_t at_ = 0, values_ = 0;
    std::string why_;
};

}  // namespace

Result<FieldValue> jsonValue(std::string_view text)
{
    return JsonParser(text).parse();
}

}  // namespace terratact
