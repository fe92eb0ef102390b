#include "commands/expression.hpp"

#include <algorithm>

namespace osem::host {

const char* const expression_help =
    "EXPR joins names by | or + (union), & (intersection), - (difference) and ^ (exclusive or); ! or ~ "
    "before\n"
    "a name or a parenthesis is the complement in the root cube. ! binds most tightly, then &; the others "
    "are\n"
    "alike and are taken from left to right: a - b & c | d is (a - (b & c)) | d.";

namespace {

constexpr int most_nesting = 64;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name_part(char c) { return is_letter(c) || (c >= '0' && c <= '9'); }

// Recursive descent; parentheses and complements nest as deep as most_nesting at the most.
// NOLINTBEGIN(misc-no-recursion)
class Parser {
  public:
    Parser(std::string_view text, const std::vector<std::string>& names)
        : text_(text), names_(names), used_(names.size(), false) {}

    std::vector<CsgToken> run() {
        parse_sum();
        if (!at_end()) fail(peek() == ')' ? "there is nothing to close" : "expected an operator");
        const auto unused = std::find(used_.begin(), used_.end(), false);
        if (unused != used_.end()) {
            const auto place = static_cast<std::size_t>(unused - used_.begin());
            throw ExpressionFault("the expression does not use " + names_[place]);
        }
        return std::move(tokens_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw ExpressionFault("column " + std::to_string(at_ + 1) + ": " + what);
    }

    bool at_end() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
        return at_ == text_.size();
    }
    char peek() { return at_end() ? '\0' : text_[at_]; }
    bool take(std::string_view any_of) {
        if (at_end() || any_of.find(text_[at_]) == std::string_view::npos) return false;
        ++at_;
        return true;
    }
    void combine(Operator op) { tokens_.push_back(CsgToken::of(op)); }

    void parse_sum() {
        parse_product();
        for (;;) {
            if (take("|+")) {
                parse_product();
                combine(Operator::unite);
            } else if (take("-")) {
                parse_product();
                combine(Operator::subtract);
            } else if (take("^")) {
                parse_product();
                combine(Operator::exclusive_or);
            } else {
                return;
            }
        }
    }

    void parse_product() {
        parse_factor();
        while (take("&")) {
            parse_factor();
            combine(Operator::intersect);
        }
    }

    void parse_factor() {
        if (++nesting_ > most_nesting) fail("nested too deeply");
        if (take("!~")) {
            parse_factor();
            tokens_.push_back(CsgToken::complement());
        } else if (take("(")) {
            parse_sum();
            if (!take(")")) fail("expected )");
        } else {
            parse_name();
        }
        --nesting_;
    }

    void parse_name() {
        if (!is_letter(peek())) fail("expected a name, ! or (");
        const std::size_t start = at_;
        std::size_t end = start;
        while (end < text_.size() && is_name_part(text_[end])) ++end;
        const std::string name(text_.substr(start, end - start));
        const auto found = std::find(names_.begin(), names_.end(), name);
        if (found == names_.end()) fail("no file is given for " + name);
        const auto place = static_cast<std::size_t>(found - names_.begin());
        used_[place] = true;
        tokens_.push_back(CsgToken::of(static_cast<unsigned>(place)));
        at_ = end;
    }

    std::string_view text_;
    const std::vector<std::string>& names_;
    std::vector<bool> used_;
    std::vector<CsgToken> tokens_;
    std::size_t at_ = 0;
    int nesting_ = 0;
};
// NOLINTEND(misc-no-recursion)

} // namespace

bool is_operand_name(std::string_view text) {
    return !text.empty() && is_letter(text[0]) && std::all_of(text.begin(), text.end(), is_name_part);
}

std::vector<CsgToken> parse_expression(std::string_view text, const std::vector<std::string>& names) {
    return Parser(text, names).run();
}

} // namespace osem::host
